/**
 * LeafNodes: corners and midpoints of the leaves of a graded body-centred lattice (CoarseTets.h).
 * All answers depend only on the sets of refined cells, so they are equal on all ranks.
 */
#pragma once

#include "Octree/RefinedGrid.h"

namespace vfm
{

/// Returns whether a cell is refined; false on the finest level and outside the grid.
bool IsRefined(const RefinedGrid& levels, const OctreeKeys::LevelIndex& cell);

/// Returns whether a node of the finest grid, also one of which this rank knows no cells, is a
/// corner of a finest cell.
bool IsFineVertex(const RefinedGrid& levels, const Index3& node);

/// Returns whether a cell at an edge of a leaf is refined.
/// @param corner,next  corners of the leaf at the ends of the edge
bool HasMidpoint(
  const RefinedGrid& levels, const OctreeKeys::LevelIndex& leaf, int corner, int next);

/// Returns the level of the smallest cells of which a node of the finest grid is a corner: that of
/// the leaves around it, or one more if it is only between their corners.
int FinestLevelAt(const RefinedGrid& levels, const Index3& node);

/// Returns whether a corner of finest cells may share a tet of larger cells with another one that
/// is not next to it. Such points may have the same colour.
bool IsNearDistantVertex(const RefinedGrid& levels, const Index3& node);

} // namespace vfm
