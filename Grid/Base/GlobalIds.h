/**
 * Global ids of points and elements, computed from grid keys without communication.
 *
 * - A point has a slot from 0 to PointSlots - 1 of a grid node:
 *   id = NodeKey * PointSlots + slot + 1.
 * - An element has a slot of a cell (hexes) or node (tets): id = key * ElementSlots + slot + 1.
 *
 * Points and elements of coarser levels have ids after all of these (RefinedGrid.h).
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// Numbers of ids per node or cell of the grid.
struct IdScheme
{
  Index PointSlots;
  /// 0: elements are numbered from 1, independent of cells (TetGen).
  Index ElementSlots;
};

/// Slots of points: G or S, then up to 15 I. Slots of hexes: the core and one buffer hex
/// per face (HexTopology.h).
constexpr IdScheme HexIds{ 16, 7 };

/// Slots of tets: four lattice tets for each of the three faces of a block (TetTopology.h), each
/// cut into at most PiecesPerTet pieces.
constexpr Index PiecesPerTet = 64;
constexpr IdScheme TetIds{ 64, 12 * PiecesPerTet };

/// Checks that ids with `slots` slots per node fit in 63 bits.
/// @throws InputError  if the grid has too many nodes
void CheckIds(const CartesianGrid& grid, Index slots);

} // namespace vfm
