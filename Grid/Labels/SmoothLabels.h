/**
 * Fractions of smooth interfaces from labels, whose own interfaces are steps of whole cells.
 *
 * A smooth field of every label (AverageFractions) parts the cells between the labels (SharpFractions). Only cells that have a
 * cell with another label among the 26 around them become mixed, of the labels found there, and each keeps its own label
 * as its largest fraction; so thin parts and single cells stay, and the topology of the labels too. Then the
 * interfaces move, each label by a weight of its own, until all have their volumes again; what is left of the
 * error the mixed cells take up.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// labels: a field without mixed cells, right in all cells of the local box; so is the result. passes >= 0 of the
/// average. Returns the largest relative error of the volume of a label (void is one). The same on any number of ranks and
/// threads. Collective.
double SmoothLabels(const CartesianGrid& grid, int passes, const Partition& partition,
  Runtime& runtime, FractionField& labels);

} // namespace vfm
