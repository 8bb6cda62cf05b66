/**
 * SurfaceFractions: exact volume fractions of the solids inside closed surfaces.
 *
 * The fractions of a cell are exact except for rounding. They are bitwise identical for any box of
 * cells and any number of threads.
 */
#pragma once

#include "Base/Buffer.h"
#include "Base/Runtime.h"
#include "Surfaces/InputSurfaces.h"

namespace vfm
{

/// Computes the volume fractions of all bodies in the cells of a box, each without the bodies
/// before it. In a cell that the boundaries of a body and of an earlier one cut, their overlap is
/// measured on rays (SharedCells.h), and where they do not overlap, the fraction stays exact. Where
/// a body overlaps itself, it counts once; in a cell that both of its overlapping boundaries cut,
/// the fraction is an upper bound.
/// @param coordinates  node coordinates of the whole grid, one list per axis
/// @param cells  cells to compute
/// @param runtime  receives the progress, 0 to 1
/// @return one array per body over the cells of the box, x fastest
/// @throws Aborted  if the user stops the run
std::vector<Buffer<double>> FractionsOfSurfaces(
  const std::array<std::vector<double>, 3>& coordinates, const IndexBox& cells,
  const InputSurfaces& surfaces, Runtime& runtime);
std::vector<Buffer<double>> FractionsOfSurfaces(
  const std::array<std::vector<double>, 3>& coordinates, const IndexBox& cells,
  const std::vector<const ClosedSurface*>& surfaces, Runtime& runtime);

/// Limits each array, cell by cell, to what the arrays before it leave of 1.
void LimitSums(std::vector<Buffer<double>>& fractions, Runtime& runtime);

} // namespace vfm
