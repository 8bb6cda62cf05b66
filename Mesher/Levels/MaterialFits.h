/**
 * MaterialFits: finds how well cells of a width represent each material, by the labels that they
 * give to the cells of the input: the largest fraction at their centres, interpolated linearly
 * between the centres of the wider cells.
 */
#pragma once

#include "Base/Runtime.h"
#include "Labels/Labels.h"

namespace vfm
{

/// A material in the cells of the input and in wider cells. Numbers of cells of the input.
struct MaterialFit
{
  Index Cells = 0;  ///< of the material
  Index Lost = 0;   ///< of the material that wider cells give to others
  Index Gained = 0; ///< of others that wider cells give to the material
  Index Sides = 0;  ///< sides of cells between the material and others

  /// Returns the area of the surface in sides of cells: a plane in any direction has about 3/2 of
  /// its area in steps.
  double Area() const { return static_cast<double>(this->Sides) / 1.5; }
  /// Returns the mean distance between the surfaces in both, in widths of cells of the input.
  double Distance() const
  {
    return this->Sides > 0 ? static_cast<double>(this->Lost + this->Gained) / this->Area() : 0.0;
  }
};

/// Compares materials 0, 1, .. in owned cells and in wider cells, on all ranks.
/// @param grid,fractions cells of the input, with two layers of wider cells around the owned ones
/// @param labels labels of these cells
/// @param wider nodes of the wider cells
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks.
std::vector<MaterialFit> FindFits(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const std::array<std::vector<double>, 3>& wider, double isoValue,
  Runtime& runtime);

} // namespace vfm
