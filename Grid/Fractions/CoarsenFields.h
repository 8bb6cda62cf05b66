/**
 * CoarsenFields: coarser grids made of blocks of cells, and the fractions on them. They are the
 * levels of a refined grid, made from the finest one.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Returns the grid whose cells are blocks of 2^halvings cells along each axis, with
/// the same owned region.
/// @param ghostLayers  number of ghost layers, in coarse cells
/// @throws InputError  if blocks do not fill the grid and the owned box exactly
CartesianGrid CoarsenGrid(const CartesianGrid& grid, int halvings, int ghostLayers);

/// Returns how many coarse ghost layers the local box of a grid contains entirely, at most `most`.
int CountCoarseGhosts(const CartesianGrid& grid, int halvings, int most);

/// Returns the means of fractions on a coarser grid, weighted by volume. Cells of one label are
/// handled in runs.
/// @param grid,fractions  must contain all cells of the local box of `coarse`
/// @param coarse  CoarsenGrid(grid, halvings, g) for any g
/// @note Bitwise reproducible on any number of ranks and threads.
FractionField CoarsenFractions(const CartesianGrid& grid, const FractionField& fractions,
  int halvings, const CartesianGrid& coarse, Runtime& runtime);

} // namespace vfm
