/**
 * Global ids: made from the index of a node, cell or face and a slot, so no rank needs to ask another.
 *
 * A point is slot 0 .. PointSlots - 1 of a grid node: id = NodeKey * PointSlots + slot + 1.
 * An element is a slot of a cell (hexes) or node (tets): id = key * ElementSlots + slot + 1.
 * What refinement makes beside the cells of the finest grid is numbered after these (RefinedGrid.h).
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// How many ids there are to a node or cell of the grid.
struct IdScheme
{
  Index PointSlots;
  Index ElementSlots; ///< 0: elements are counted from 1, and know no cell (TetGen)
};

/// Points: G or S, then up to 15 I. Hexes: the core and a buffer hex a face (HexTopology.h).
constexpr IdScheme HexIds{ 16, 7 };

/// Tets: four of the lattice to each of the three faces of a block (TetTopology.h), each cut into pieces.
constexpr Index PiecesPerTet = 64;
constexpr IdScheme TetIds{ 64, 12 * PiecesPerTet };

/// Throws InputError when ids of so many slots a node do not fit in 63 bits.
void CheckIds(const CartesianGrid& grid, Index slots);

} // namespace vfm
