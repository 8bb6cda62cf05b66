/**
 * Coarser grids of a grid, and its fractions on them: what the levels of a refined grid are, seen from the finest one.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// The grid whose cells are 2^halvings cells of a grid along each axis, with the same owned cells and so many ghost layers of its
/// own. Throws InputError when whole cells do not make up the grid and the owned box.
CartesianGrid CoarsenGrid(const CartesianGrid& grid, int halvings, int ghostLayers);

/// Of the ghost layers of such a grid, the most that the grid's local box holds whole, not above a bound.
int CountCoarseGhosts(const CartesianGrid& grid, int halvings, int most);

/// Means of the fractions of a grid, weighted with volumes, on CoarsenGrid(grid, halvings, g); the grid must hold all cells of its
/// local box. Cells of one label follow by runs. The same on any number of ranks and threads.
FractionField CoarsenFractions(const CartesianGrid& grid, const FractionField& fractions,
  int halvings, const CartesianGrid& coarse, Runtime& runtime);

} // namespace vfm
