/**
 * SmoothLabels: fractions of smooth interfaces, from labels whose own interfaces are
 * steps of entire cells.
 *
 * A smooth field of every label (AverageFractions) divides the cells among the labels
 * (SharpFractions). Only cells with another label among the 26 cells around them become mixed, of
 * the labels found there. Each keeps its own label as its largest fraction. So thin parts and
 * single cells remain, and the topology of the labels too. Then a weight per label moves the
 * interfaces until all labels have their volumes again. The mixed cells absorb the remaining error.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Replaces labels by fractions of smooth interfaces.
/// @param passes  number of passes of the average, >= 0
/// @param[in,out] labels  valid in all cells of the local box, before and after;
///   starts without mixed cells
/// @return largest relative error of the volume of a label, void included
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks and threads.
double SmoothLabels(const CartesianGrid& grid, int passes, const Partition& partition,
  Runtime& runtime, FractionField& labels);

/// Returns a sentence on an error of SmoothLabels, or "" if it is small.
std::string DescribeVolumeError(double error);

} // namespace vfm
