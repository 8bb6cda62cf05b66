/**
 * InterfaceCurvature: curvature of interfaces, from fractions. In each mixed cell a paraboloid
 * is fitted to the centroids of the interface planes in the mixed cells around, in the frame
 * of its own plane.
 *
 * Lengths are in cells; cells of uneven grids count as cubes. Edges and corners have a curvature
 * of about 1 per cell width. Faces between pure cells have no planes, so labels without
 * fractions give no curvature.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionField.h"

#include <vector>

namespace vfm
{

/// Distance, in cells along each axis, of the cells that are read.
constexpr int CurvatureReach = 3;

/// Curvature of the interface in a cell.
struct CellCurvature
{
  Index Cell; ///< linear index
  /// Magnitude of the larger principal curvature, times the width of a cell.
  double Curvature;
};

/// Finds the curvature in the owned cells that have two parts and enough planes around.
/// @param fractions  the cells within CurvatureReach of owned cells must be in the local box or
///   outside the domain
/// @return ascending by cell
/// @note Bitwise reproducible on any number of ranks and threads.
std::vector<CellCurvature> FindCurvatures(
  const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime);

} // namespace vfm
