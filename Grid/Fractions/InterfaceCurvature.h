/**
 * The curvature of interfaces, from fractions: a paraboloid through the planes in the mixed cells around (their middles),
 * in the frame of the one in the cell.
 *
 * Everything is in cells: those of uneven grids count as cubes. Edges and corners come out as curved by about one over a
 * cell. Faces between pure cells have no planes: labels without fractions tell no curvature.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionField.h"

#include <vector>

namespace vfm
{

/// Cells within so many levels of a cell are read.
constexpr int CurvatureReach = 3;

struct CellCurvature
{
  Index Cell; ///< linear
  double
    Curvature; ///< the larger of the two principal ones by magnitude, times the width of a cell
};

/// Of the owned cells with two parts where it can be told, in the order of the grid. The cells around must be in the local
/// box or outside the domain. The same on any number of ranks and threads.
std::vector<CellCurvature> FindCurvatures(
  const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime);

} // namespace vfm
