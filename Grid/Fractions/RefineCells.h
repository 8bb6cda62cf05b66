/**
 * RefineCells: divides every cell of a grid into 2x2x2 or other numbers of children, and the
 * fractions among them.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/CellDivision.h"
#include "Fractions/FractionField.h"

#include <functional>

namespace vfm
{

/// Rule that divides a mixed cell among its children.
enum class ChildRule
{
  Planes, ///< separates parts by planes that keep every volume (ChildFractions.h)
  Parent  ///< gives each child the fractions of the cell
};

/// Returns the fractions in the children of a mixed cell, x fastest, one list per part of the cell;
/// nothing if they are not known. Threads may call it at the same time.
using KnownChildren = std::function<std::vector<std::vector<double>>(const Index3& cell)>;

/// A grid and its fractions.
struct RefinedCells
{
  CartesianGrid Grid;
  FractionField Fractions;
};

/// Returns the node coordinates of a grid whose cells are halved `times` times along each axis. A
/// negative number joins pairs of cells.
std::array<std::vector<double>, 3> HalveWidths(
  std::array<std::vector<double>, 3> coordinates, int times = 1);
/// Returns the grid of the same domain and owned region whose cells are halved `levels` times, or
/// joined if the number is negative. Copies of cells on a periodic grid cover the same region.
CartesianGrid ChangeLevel(const CartesianGrid& grid, int levels, int ghostLayers);

/// Halves the owned cells along each axis, with GhostLayers layers of half cells around them.
/// Children of pure cells get their label, children of mixed cells fractions with the same mean.
/// Nothing is communicated.
/// @param grid  the whole domain, or the part of a rank with at least four ghost layers
/// @param fractions  owned and ghost cells
/// @param skips  skips(cell): whether the children of a cell are not needed; they become
///   void; may be empty
/// @param known  fractions that replace those of the rule; may be empty
/// @throws InputError  if the finer grid has too many nodes for 64-bit ids, or coordinates too
///   close to halve
/// @note Bitwise reproducible on any number of ranks and threads.
RefinedCells RefineCells(const CartesianGrid& grid, const FractionField& fractions,
  Runtime& runtime, ChildRule rule = ChildRule::Planes,
  const std::function<bool(const Index3&)>& skips = {}, const KnownChildren& known = {});

/// Divides the owned cells. The GhostLayers layers around them are void: a child may be as wide as
/// its cell, so FillGhosts must get them from their owners. Otherwise like RefineCells.
/// @param grid  has at least one ghost layer
RefinedCells DivideCells(const CartesianGrid& grid, const FractionField& fractions,
  const CellDivision& division, Runtime& runtime, ChildRule rule = ChildRule::Planes);

} // namespace vfm
