/**
 * How thick the region of a material, or of void, is at a cell: from the fractions, so that films of less than a cell
 * count, and oblique ones for which labels have holes.
 *
 * The fractions are summed along the line through the cell on which they change the most: across a film, from the surface
 * of a body inwards, at a sharp edge along the middle between its faces. From the largest fraction near the cell the
 * sum goes both ways to where there is no more of the material, or to where there is the least of it before the next region
 * begins. Of films that is the thickness to about two tenths of a cell; rods and balls thinner than two cells give less,
 * since cells hold more than them across the line too. Where the region is thicker at the cell around that holds the most of it
 * that counts: so corners of thick bodies are thick.
 *
 * Everything is in cells: those of uneven grids count as cubes. The sides of the domain are mirrors.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// Cells within so many levels of a cell are read.
constexpr int ThicknessReach = 6;
/// The largest thickness that can be told.
constexpr double LargestThickness = 3.0;

/// The thickness of the region of a material (0 void) at a cell that holds some of it, or enough when it is not less;
/// enough: at most LargestThickness. The cells around must be in the local box or outside the domain.
double FindThickness(const CartesianGrid& grid, const FractionField& fractions, const Index3& cell,
  int material, double enough);

} // namespace vfm
