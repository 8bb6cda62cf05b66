/**
 * PlaceHostBoxes: finds the grid of all ranks, and the places of boxes in it, from bounding boxes.
 */
#pragma once

#include "HostGrid.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Box of cells of one level.
struct BoundedCells
{
  Vector3 Lower, Upper;         ///< bounding box, length units of the host
  std::array<int, 3> Intervals; ///< numbers of cells along x, y, z
  int Level = 0;                ///< 0 for the coarsest cells
};

/// Runs work(). If there are several blocks, errors name this one, counted from 0.
template <class Work>
void NameBlock(std::size_t block, std::size_t blocks, const Work& work)
{
  PrefixErrors(blocks > 1 ? "Block " + std::to_string(block) + ": " : "", work);
}

/// Checks a box. Not collective.
/// @throws InputError  if a length is not finite or not above 0, an interval below 1, or the level
///   out of range
void CheckBoundedCells(const BoundedCells& cells);

/// Places the boxes of all ranks in one grid.
/// @param mine  checked boxes of this rank; may be empty, but not on all ranks
/// @return grid of this rank's boxes, without arrays. Origin, spacing and cells follow from the
///   boxes of all ranks, so they are bitwise identical on all ranks, however boxes are distributed.
/// @throws InputError  on all ranks, if a cell of level L is not 1/2^L as wide as cells of level 0,
///   or a box deviates from the grid by more than 1e-3 of its cells
/// @pre Collective
HostGrid PlaceHostBoxes(const std::vector<BoundedCells>& mine, Ranks& ranks);

} // namespace vfm
