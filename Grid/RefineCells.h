/**
 * Every cell of a grid cut in 2x2x2, and the fractions of the halves.
 */
#pragma once

#include "FractionField.h"
#include "Runtime.h"

namespace vfm
{

struct RefinedCells
{
  CartesianGrid Grid;
  FractionField Fractions;
};

/// The owned cells halved along each axis, with GhostLevels levels of half cells around them. grid: the whole domain,
/// or a rank's part with ghost levels of its own: four are read. Pure cells give their label to their children, mixed
/// ones fractions that average to theirs (ChildFractions.h). The same on any number of ranks and threads; nothing is
/// communicated. Throws InputError when the finer grid has too many nodes for 64-bit ids, or coordinates too near to halve.
RefinedCells RefineCells(
  const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime);

} // namespace vfm
