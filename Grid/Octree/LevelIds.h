/**
 * LevelIds: ids of the points and elements of refined grids.
 *
 * Points and elements of finest cells have the same ids as in a mesh without levels (GlobalIds.h).
 * The ids of coarse hexes follow, computed from the keys of OctreeKeys. A lattice node that is a
 * corner of a finest cell has the id of a point of that cell. The parameter `slots` is the number
 * of slots per node or cell of the finest grid.
 */
#pragma once

#include "Octree/RefinedGrid.h"

namespace vfm
{

/// PointId and ElementId return the id of a point or element from its key in the lattice.
Index PointId(const RefinedGrid& grid, Index key, Index slots, int slot = 0);
Index ElementId(const RefinedGrid& grid, Index key, Index slots, int slot = 0);
/// IsCoarsePoint and IsCoarseElement return whether a point or element belongs to the coarse hexes.
bool IsCoarsePoint(const RefinedGrid& grid, Index id, Index slots);
bool IsCoarseElement(const RefinedGrid& grid, Index id, Index slots);
/// Returns whether a point is a lattice node or a copy of one, not a point of an interface.
inline bool IsLatticePoint(const RefinedGrid& grid, Index id, Index slots)
{
  return IsCoarsePoint(grid, id, slots) || (id - 1) % slots == 0;
}
/// Returns the lattice key of a lattice point, or of the node that it is a copy of.
Index KeyOfPoint(const RefinedGrid& grid, Index id, Index slots);
/// NodeOfCoarsePoint returns the node of a point of coarse hexes; CellOfCoarseElement the cell
/// of a coarse hex.
Index3 NodeOfCoarsePoint(const RefinedGrid& grid, Index id, Index slots);
OctreeKeys::LevelIndex CellOfCoarseElement(const RefinedGrid& grid, Index id, Index slots);

/// Number of tets per cell: up to 8 per side.
constexpr Index TetsOfCell = 48;
/// The following functions are for tets (CoarseTets.h). Points that are not corners of finest cells
/// have ids computed from lattice keys. The centres of coarse cells are points with ids after all
/// others. A tet has a number from 0 to 47 in its cell, whose key is a hex key of slot 0.
Index CoarsePointId(const RefinedGrid& grid, Index key, Index slots, int slot = 0);
Index CentreId(const RefinedGrid& grid, Index hexKey, Index slots);
Index TetId(const RefinedGrid& grid, Index hexKey, Index number, Index slots);
bool IsCoarseCentre(const RefinedGrid& grid, Index id, Index slots);
bool IsCoarseTet(const RefinedGrid& grid, Index id, Index slots);
OctreeKeys::LevelIndex CellOfCoarseCentre(const RefinedGrid& grid, Index id, Index slots);
OctreeKeys::LevelIndex CellOfCoarseTet(const RefinedGrid& grid, Index id, Index slots);
/// Returns a number larger than the id of every point of tets.
Index EndOfPointIds(const RefinedGrid& grid, Index slots);

} // namespace vfm
