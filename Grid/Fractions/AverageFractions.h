/**
 * AverageFractions: repeated averages of fractions over adjacent cells, which smooth
 * the steps of labels.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Averages fractions over adjacent cells. In each pass a cell gets 1/4, 1/2, 1/4 of the
/// fractions of the three cells along x, then the same along y and z. The thinner of two cells
/// limits their exchange. Cells on a side of the domain exchange nothing along the axis across
/// it, so planes stay planes.
/// @param fractions  owned and ghost cells
/// @return valid in the owned cells and one layer around them
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks and threads.
FractionField AverageFractions(const CartesianGrid& grid, FractionField fractions, int passes,
  const Partition& partition, Runtime& runtime);

} // namespace vfm
