/**
 * SlabPillow: one level of two-refinement. Refined cells become eight, the cells around them transition hexes.
 *
 * For each axis in turn: the two layers of families of index t form a slab. The hexes of the slab that are refined or beside
 * a refined family of it get a pillow: each outer face of that set gets a new hex, each node of such a face a copy, the
 * hexes inside keep the copies. Refined cells are split in two layers that way, and pillowing keeps any mesh conforming.
 * After three axes a refined cell is its eight children; a cell that shares a face with one has about seven hexes, an edge
 * four. The sheets are those of Owen, Shih, Ernst, "A template-based approach for parallel hexahedral two-refinement"
 * (2017), without its templates.
 *
 * On the domain boundary only a face across the axis at the end of a slab is pillowed; elsewhere the sheet ends there.
 *
 * Slot of a node: three digits of base 3, x lowest: 0 not copied for that axis; else 1 where its lattice node is in the
 * middle of a slab or on the upper end of the one it was copied in, 2 on the lower end.
 * Slot of a hex: three digits of base 7, x lowest: 0 the hex that was there, 1 + f made on its local face f (-x +x .. +z).
 *
 * Positions: a copy lies half way along the mean of the old edges that its pillow faces leave behind, summed over their
 * directions; a quarter where two directions have no corner in common (a concave place). This makes exact midpoints in
 * refined cells. At concave corners it inverts some transition hexes: see TransitionSmoothing.h.
 */
#pragma once

#include "Octree/OctantFamilies.h"

namespace vfm
{

struct PillowedLevel
{
  struct Node
  {
    Index3 Base; ///< the lattice node it stems from
    int Slot;
    int Sides; ///< of the domain, a bit each
    Vector3 X; ///< lattice coordinates (OctreeKeys::ToPoint)
  };
  struct Hex
  {
    std::array<int, 8> Nodes; ///< by corner bits, x first
    int Cell;                 ///< in Cells
    int Slot;
  };

  std::vector<Index3> Cells; ///< the touched ones
  std::vector<Node> Nodes;
  std::vector<Hex> Hexes;
};

/// The child (corner bits) that a hex of a refined cell is.
int ChildOfHex(const Index3& cell, int slot);

/// Refines the cells of a level in a box of its cells and around it. Inside the box all is as in the whole grid.
PillowedLevel PillowSlabs(const OctantFamilies& sets, int level, const IndexBox& box);

} // namespace vfm
