/**
 * GridCoordinates: points in coordinates of the grid. They start at its lowest node, and their unit
 * is the mean width of its cells.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// Converts a point from length units of the grid to grid coordinates.
Vector3 ToGrid(const CartesianGrid& grid, const double* point);

/// Converts coordinates of nodes along each axis.
std::array<std::vector<double>, 3> ToGrid(
  const CartesianGrid& grid, std::array<std::vector<double>, 3> nodes);

/// Returns the sides of the domain on which a point lies: bit f is set for side f.
/// @param point  length units of the grid
int FindDomainSides(const CartesianGrid& grid, const double* point);

} // namespace vfm
