/**
 * Fractions averaged over the cells around, several times: what smooths the steps of labels.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Each pass gives a cell 1/4, 1/2, 1/4 of what the three cells along x hold, then the same along y and z. Between cells of
/// different widths the thinner one decides how much passes. Cells on a side of the domain take nothing along the axis across it, so that
/// planes stay planes. The result is right in the owned cells and the layer around them. The same on any number of ranks and threads.
/// Collective.
FractionField AverageFractions(const CartesianGrid& grid, FractionField fractions, int passes,
  const Partition& partition, Runtime& runtime);

} // namespace vfm
