/**
 * Blocks of cells and images of labels as input of the mesher.
 */
#pragma once

#include "Mesher.h"

namespace vfm
{
namespace testing
{

/// Returns a block of cells of equal width.
/// @param cells of the grid
/// @param origin position of cell 0 along each axis
InputBlock MakeBlock(const IndexBox& cells, const Vector3& origin, double width,
  std::shared_ptr<const BlockArrays> arrays);
/// Returns an input of blocks of this rank; the arrays have no names yet.
MesherInput MakeInput(std::vector<InputBlock> blocks, Ranks& ranks);

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

/// Returns the blocks of a rank of an input of two levels: a grid of label 1, and boxes of it of
/// random labels in cells of half the width. Blocks are dealt to the ranks in turn.
MesherInput MakeLevelInput(const LabelGrid& grid, const std::vector<IndexBox>& boxes, Ranks& ranks);

} // namespace testing
} // namespace vfm
