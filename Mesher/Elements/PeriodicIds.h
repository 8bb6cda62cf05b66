/**
 * PeriodicIds: ids of the copies of points and tets on a periodic grid (CartesianGrid.h).
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Mesh.h"
#include "Elements/PointExchange.h"
#include "Octree/OctreeKeys.h"

namespace vfm
{

/// Returns the copy of a node or cell that is some cells of a level lower.
/// @param cells  cells of `level`; whole cells of the level of `at`
OctreeKeys::LevelIndex Below(OctreeKeys::LevelIndex at, const Index3& cells, int level);

/// Returns whether points at a node can have copies in a mesh of owned cells and ghosts: whether
/// the node lies on a seam or beyond.
bool HasCopies(const CartesianGrid& grid, const Index3& node);

/// Returns the id that a point has on a peer, which has the node of the point `ShiftOf` lower.
Index IdAtPeer(const Mesh& mesh, const Partition& partition, std::size_t peer, Index id);

/// Returns the id of the copy of a point whose node is owned by a rank. Equal for all copies.
Index IdOfOwner(const Mesh& mesh, Index id);

/// Returns how movers that are points of a mesh change between copies, with positions in mean
/// widths of the finest grid.
/// @param halvings  number of halvings from cells of the partition's grid to finest cells
MoverCopies CopiesOfMovers(const Mesh& mesh, int halvings = 0);
/// Returns the same for movers whose ids are keys of lattice nodes, on a partition of the base
/// grid.
/// @param unit  unit of positions along each axis, in length units
MoverCopies CopiesOfAnchors(const OctreeKeys& lattice, const Vector3& unit);

} // namespace vfm
