/**
 * Images of labels as input of the mesher.
 */
#pragma once

#include "Mesher.h"

namespace vfm
{
namespace testing
{

/// A grid with cells of equal width.
struct LabelGrid
{
  Index3 Cells;
  double Origin, Width; ///< along each axis
};

/// Returns a random label from 0 to 2 for each cell.
std::vector<int> RandomLabels(const Index3& cells, unsigned seed);

/// Returns the part of a rank of an image of labels, cut across z.
/// @param labels of all cells, x fastest
MesherInput MakeLabelInput(const LabelGrid& grid, const std::vector<int>& labels, Ranks& ranks);

} // namespace testing
} // namespace vfm
