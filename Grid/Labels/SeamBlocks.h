/**
 * SeamBlocks: the cells that meet across the flat seams of a periodic grid.
 *
 * A block is the two cells of a column across a seam, or the four or eight cells at an edge or
 * corner of the domain, where several seams meet. Blocks are disjoint. A block is glued along an
 * axis if the labels of its cells are equal across that axis. Glued cells have one label, so no
 * face of it is on the seam between them.
 */
#pragma once

#include "Labels/Labels.h"

namespace vfm
{

/// Returns the block of a cell; a cell without a flat seam is a block.
/// @pre The block is in the local box.
IndexBox BlockOfCell(const CartesianGrid& grid, const Index3& cell);

/// Returns the axes along which a block of several cells is glued: bit a is set for axis a.
int FindGluedAxes(const CartesianGrid& grid, const LabelArray& labels, const IndexBox& block);

/// Returns the cells of a block that differ from one of them along the given axes only.
IndexBox PartOfBlock(const IndexBox& block, int axes, const Index3& cell);

} // namespace vfm
