/**
 * ThinFeatures: thickness of the region of a material, or of void, at a cell. It is measured from
 * the fractions, so films thinner than a cell count, and oblique films whose labels have holes.
 *
 * The fractions are summed along the line through the cell on which they change most. It runs
 * across a film, from the surface of a body inwards, and from a sharp edge between its faces. The
 * sum starts at the largest fraction near the cell and goes both ways. It ends where the material
 * ends, or at the least fraction before the next region. For films this is the thickness to about
 * 0.2 cells. Rods and balls thinner than two cells give less, since cells extend beyond them across
 * the line too. If the region is thicker at the adjacent cell with the largest fraction, that
 * thickness counts, so corners of thick bodies are thick.
 *
 * Lengths are in cells; cells of uneven grids count as cubes. The sides of the
 * domain act as mirrors.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// Distance, in cells along each axis, of the cells that are read.
constexpr int ThicknessReach = 6;
/// Largest thickness that can be measured.
constexpr double LargestThickness = 3.0;

/// Returns the thickness of the region of a material at a cell, or `enough` if it is not smaller.
/// @param fractions  the cells within ThicknessReach must be in the local box or outside the domain
/// @param cell  position of a cell that holds some of the material
/// @param material  0 is void
/// @param enough  thickness of interest, at most LargestThickness
double FindThickness(const CartesianGrid& grid, const FractionField& fractions, const Index3& cell,
  int material, double enough);

} // namespace vfm
