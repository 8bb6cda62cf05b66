/**
 * LevelIds: ids of the points and elements of refined grids, in a mesh with so many slots a node or cell of the finest grid.
 *
 * The points and elements of finest cells have those of a mesh without levels; those of the coarse hexes follow, by the
 * keys of OctreeKeys. A lattice node that a fine cell has as a corner is a point of that cell.
 */
#pragma once

#include "Octree/RefinedGrid.h"

namespace vfm
{

/// Of what has a key in the lattice.
Index PointId(const RefinedGrid& grid, Index key, Index slots, int slot = 0);
Index ElementId(const RefinedGrid& grid, Index key, Index slots, int slot = 0);
/// Whether a point or an element is one of the coarse hexes.
bool IsCoarsePoint(const RefinedGrid& grid, Index id, Index slots);
bool IsCoarseElement(const RefinedGrid& grid, Index id, Index slots);
/// Whether a point is a node of the lattice or a copy of one: no point of an interface.
inline bool IsLatticePoint(const RefinedGrid& grid, Index id, Index slots)
{
  return IsCoarsePoint(grid, id, slots) || (id - 1) % slots == 0;
}
/// The key of such a point, or of the node that it was split from, in the lattice.
Index KeyOfPoint(const RefinedGrid& grid, Index id, Index slots);
/// The node, and the cell, that a point or an element of the coarse hexes stems from.
Index3 NodeOfCoarsePoint(const RefinedGrid& grid, Index id, Index slots);
OctreeKeys::LevelIndex CellOfCoarseElement(const RefinedGrid& grid, Index id, Index slots);

/// The same of tets (CoarseTets.h): points that no finest cell of HexBox has go by their keys, the centres of coarse hexes are
/// points after all others, a tet is number 0..23 of a hex.
constexpr Index TetsOfHex = 24;
Index CoarsePointId(const RefinedGrid& grid, Index key, Index slots, int slot = 0);
Index CentreId(const RefinedGrid& grid, Index hexKey, Index slots);
Index TetId(const RefinedGrid& grid, Index hexKey, Index number, Index slots);
bool IsCoarseCentre(const RefinedGrid& grid, Index id, Index slots);
bool IsCoarseTet(const RefinedGrid& grid, Index id, Index slots);
OctreeKeys::LevelIndex CellOfCoarseCentre(const RefinedGrid& grid, Index id, Index slots);
OctreeKeys::LevelIndex CellOfCoarseTet(const RefinedGrid& grid, Index id, Index slots);
/// Larger than the id of any point of tets.
Index EndOfPointIds(const RefinedGrid& grid, Index slots);

} // namespace vfm
