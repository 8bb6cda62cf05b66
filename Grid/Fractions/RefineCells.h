/**
 * Every cell of a grid cut in 2x2x2 or otherwise, and the fractions of its children.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/CellDivision.h"
#include "Fractions/FractionField.h"

#include <functional>

namespace vfm
{

/// How a mixed cell is shared out to its children.
enum class ChildRule
{
  Planes, ///< by planes that keep every volume (ChildFractions.h)
  Parent  ///< each gets the fractions of the cell
};

struct RefinedCells
{
  CartesianGrid Grid;
  FractionField Fractions;
};

/// The node coordinates of a grid whose cells are halved along each axis, so many times; negative: joined in twos.
std::array<std::vector<double>, 3> HalveWidths(
  std::array<std::vector<double>, 3> coordinates, int times = 1);

/// The owned cells halved along each axis, with GhostLayers layers of half cells around them. grid: the whole domain,
/// or a rank's part with ghost layers of its own: four are read. Pure cells give their label to their children, mixed
/// ones fractions that average to theirs. The same on any number of ranks and threads; nothing is
/// communicated. skips(cell): whether the halves of a cell are not wanted, they are void then; may be empty.
/// Throws InputError when the finer grid has too many nodes for 64-bit ids, or coordinates too near to halve.
RefinedCells RefineCells(const CartesianGrid& grid, const FractionField& fractions,
  Runtime& runtime, ChildRule rule = ChildRule::Planes,
  const std::function<bool(const Index3&)>& skips = {});

/// The owned cells cut as a division of the grid says, and GhostLayers layers around them, which are void: FillGhosts gets them
/// from their owners, since a child may be as wide as its cell. grid: with a ghost layer at least. Otherwise as RefineCells.
RefinedCells DivideCells(const CartesianGrid& grid, const FractionField& fractions,
  const CellDivision& division, Runtime& runtime, ChildRule rule = ChildRule::Planes);

} // namespace vfm
