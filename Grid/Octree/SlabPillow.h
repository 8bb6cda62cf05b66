/**
 * SlabPillow: divides each refined cell of one level into eight cells, and the cells around into
 * transition hexes.
 *
 * The following is done for each axis in turn. The two layers of cells of families with index t
 * form a slab. The hexes of the slab that are refined, or next to a refined family of it, get a
 * pillow. Each outer face of this set gets a new hex and each node of such a face a copy; the hexes
 * inside use the copies. This divides refined cells into two layers, and pillowing keeps any mesh
 * conforming. After three axes, a refined cell is its eight children; a cell that shares a face
 * with a refined one has about seven hexes, a cell that shares an edge four. The sheets follow S.
 * J. Owen, R. M. Shih, C. D. Ernst, "A template-based approach for parallel hexahedral
 * two-refinement", Computer-Aided Design (2017), without its templates.
 *
 * On the domain boundary, only faces across the axis at the end of a slab are pillowed; elsewhere
 * the sheet ends at the boundary. Flat seams are ends of slabs, and copies of their nodes stay in
 * them, except across the axis of the slab.
 *
 * The slot of a node has three digits of base 3, x lowest. A digit 0 means not copied for this
 * axis. 1 means copied, with the lattice node in the middle or on the upper end of the slab; 2 the
 * same with the lattice node on the lower end.
 *
 * The slot of a hex has three digits of base 7, x lowest. A digit 0 means the original hex, 1 + f a
 * hex made on its local face f (-x +x .. +z).
 *
 * A copy moves from the position of its original by half the mean of the old edges behind its
 * pillow faces, summed over the directions of these faces. It moves by a quarter if two directions
 * have no corner in common (a concave place). This makes exact midpoints in refined cells. Some
 * transition hexes at concave corners are inverted by it (TransitionSmoothing.h).
 */
#pragma once

#include "Octree/OctantFamilies.h"

namespace vfm
{

/// Touched cells of a level, and the nodes and hexes made of them.
struct PillowedLevel
{
  struct Node
  {
    Index3 Base; ///< lattice node from which it stems
    int Slot;
    int Sides; ///< sides of the domain, one bit each
    int Seams; ///< axes across which it lies on a flat seam, one bit each
    Vector3 X; ///< position in lattice coordinates (OctreeKeys::ToPoint)
  };
  struct Hex
  {
    std::array<int, 8> Nodes; ///< nodes by corner bits, x lowest
    int Cell;                 ///< index in Cells
    int Slot;
  };

  std::vector<Index3> Cells; ///< touched cells
  std::vector<Node> Nodes;
  std::vector<Hex> Hexes;
};

/// Returns the child, as corner bits, that a hex of a refined cell is.
int ChildOfHex(const Index3& cell, int slot);

/// Refines the cells of a level in a box and around it. Inside the box, the result is the same as
/// for the whole grid.
/// @param box  box of cells of the level
PillowedLevel PillowSlabs(const OctantFamilies& sets, int level, const IndexBox& box);

} // namespace vfm
