/**
 * PlaceGrid: the grid of cells around closed surfaces, for all front ends.
 */
#pragma once

#include "Surfaces/InputSurfaces.h"

#include <array>
#include <string>
#include <vector>

namespace vfm
{

/// Number of cells between surfaces and each side of a grid around them, at least.
constexpr Index PlaceMargin = 2;

/// Number of cells that a grid around surfaces needs along each axis.
constexpr Index LeastPlacedCells = 2 * PlaceMargin + 1;

/// Bounds of surfaces.
struct PlaceBounds
{
  Vector3 Lower, Upper;
};

/// Grid of equal cells.
struct GridPlace
{
  Vector3 Origin; ///< first corner of the first cell
  Vector3 Widths; ///< of each cell
  Index3 Cells;   ///< numbers of cells along the axes
};

/// Returns the bounds of the triangles of all bodies.
/// @throws InputError  if there are no triangles
PlaceBounds FindBounds(const InputSurfaces& surfaces);

/// Places cubic cells around the bounds, centred, with PlaceMargin cells between them and each side
/// at least.
/// @param cells  numbers of cells along the axes
/// @throws InputError  if a number is below LeastPlacedCells, the bounds have no extent, or there
///                     would be too many cells
GridPlace PlaceCells(const PlaceBounds& bounds, const Index3& cells);

/// Places cubic cells around the bounds. Along the shorter sides, there are as many as the margin
/// requires.
/// @param cells  number along the longest side
/// @throws InputError  as above
GridPlace PlaceCells(const PlaceBounds& bounds, Index cells);

/// Places as many cells around the bounds as the margin requires.
/// @param widths  widths of the cells along the axes, above 0
/// @throws InputError  if the bounds have no extent, or there would be too many cells
GridPlace PlaceCellsOfWidth(const PlaceBounds& bounds, const Vector3& widths);

/// Returns the coordinates of the nodes along the axes.
std::array<std::vector<double>, 3> ListNodes(const GridPlace& place);

} // namespace vfm
