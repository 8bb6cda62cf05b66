/**
 * LevelSetCell: volume fractions of one cell from level sets, functions that are negative inside
 * their material.
 *
 * A function is known at the centres of the cells around the cell. Between them it is interpolated
 * by cubic polynomials along each axis, except where its slope jumps: there the lines on both sides
 * are extended up to where they cross, as by subcell resolution (Harten, J. Comput. Phys. 83 (1989)
 * 148-184). The cell is cut into 2^3 and into 4^3 parts, each part into six tetrahedra, in which
 * the functions are linear and the volumes are exact. The volumes of both are extrapolated
 * (Richardson), so that their error is of fourth order in the width of the cells. Planes are exact.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Fractions/LevelSetRule.h"

#include <vector>

namespace vfm
{

/// Layers of cells around a cell whose values its fractions depend on.
constexpr int LevelSetLayers = 2;
constexpr int StencilWidth = 2 * LevelSetLayers + 1;
constexpr int StencilCells = StencilWidth * StencilWidth * StencilWidth;

/// Values of one function in the cells around a cell, x fastest; NaN: not known.
using StencilValues = std::array<double, StencilCells>;

/// Places of the cells around a cell.
struct StencilPlaces
{
  std::array<std::array<double, StencilWidth>, 3> Centres; ///< along each axis, ascending
  std::array<double, 3> Lower, Upper;                      ///< nodes of the cell
};

/// Returns the places around a cell of a grid; those outside continue with the width of the cell.
/// @param nodes  nodes of the grid along each axis
StencilPlaces PlacesAround(const std::array<std::vector<double>, 3>& nodes, const Index3& cell);

/// Replaces unknown values by extrapolation along the axes, linear or quadratic; constant where one
/// value is known only.
/// @pre The value of the cell itself is known.
void FillUnknown(const StencilPlaces& places, StencilValues& values);

/// Returns the material of all points of the cell, from 1, or 0 for void; -1 if it may be mixed.
/// Only the values of the 27 nearest cells count.
/// @param functions  values of the function of each material, all known
int FindOnlyMaterial(const std::vector<StencilValues>& functions, LevelSetRule rule);

/// Returns the fractions of all materials; their sum is at most 1.
/// @param functions  values of the function of each material, all known
std::vector<double> FractionsOfFunctions(
  const StencilPlaces& places, const std::vector<StencilValues>& functions, LevelSetRule rule);

} // namespace vfm
