/**
 * FitWidths: finds how wide the cells of each material can be, and the coarsest cells and halvings
 * of them that need the fewest elements (MaterialWidths auto).
 *
 * A material fits cells of a width if
 * - its surface stays within the allowed distance, on average over the surface,
 * - it fills at least 8 such cells,
 * - wider cells give at most 60 % of it to others (thin materials), and
 * - it has not more fragments of two such cells and more than fragments in the input.
 */
#pragma once

#include "Base/Runtime.h"
#include "Levels/CellSizes.h"
#include "Levels/MaterialFits.h"

namespace vfm
{

/// Limits of the widths of cells.
struct WidthLimits
{
  double Widest;   ///< largest width, in cells of the input
  double Distance; ///< largest distance of surfaces, in cells of the input
  int Halvings;    ///< largest number of halvings
};

/// Width that a material fits, and its extent.
struct FittedWidth
{
  double Ratio; ///< largest tried width, in cells of the input, at least 1
  MaterialFit Extent;
};

/// Returns the number of layers of ghost cells that FitWidths needs.
int LayersOf(const WidthLimits& limits);

/// Finds the widths of materials 0, 1, ..
/// @param grid,fractions cells of the input, with LayersOf layers of ghost cells
/// @param labels AssignMaterials of these
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks.
std::vector<FittedWidth> FitWidths(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const WidthLimits& limits, double isoValue, Runtime& runtime);

/// Widths that cells may have.
struct WidthChoice
{
  double Coarsest = 1.0;       ///< width of the coarsest cells, in cells of the input
  int Halvings = 0;            ///< of these until they are the finest
  std::vector<int> OfMaterial; ///< halvings until they fit materials 0, 1, ..
};

/// Returns the choice with the smallest estimated number of elements. Finest cells are not narrower
/// than those of the input.
/// @param fitted widths of materials 0, 1, ..; void takes any cells
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks.
WidthChoice ChooseWidths(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<FittedWidth>& fitted, const WidthLimits& limits, Ranks& ranks);

} // namespace vfm
