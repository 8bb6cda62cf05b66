/**
 * PlaceHostBoxes: the whole grid and the places of this rank's boxes in it, from the bounding boxes that the ranks know.
 */
#pragma once

#include "HostGrid.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// The bounding box of cells of a level (length units of the host) and how many there are along each axis.
struct BoundedCells
{
  Vector3 Lower, Upper;
  std::array<int, 3> Intervals;
  int Level = 0;
};

/// Does the work with a block, counted from 0; its errors tell which, where there are several.
template <class Work>
void NameBlock(std::size_t block, std::size_t blocks, const Work& work)
{
  PrefixErrors(blocks > 1 ? "Block " + std::to_string(block) + ": " : "", work);
}

/// Throws InputError on numbers that are not finite, a box that is flat or inside out, intervals below 1, levels out of
/// range. Not collective.
void CheckBoundedCells(const BoundedCells& cells);

/// Collective; mine: of this rank, maybe none, but some on any rank. A grid with these boxes, without arrays, whose origin and
/// spacing are those of all ranks' boxes together, so the same bits on all ranks, whichever has which box. Throws InputError, on
/// all ranks alike, when cells of a level are not those of level 0 halved or boxes are not on one grid, by more than a
/// thousandth of a cell.
HostGrid PlaceHostBoxes(const std::vector<BoundedCells>& mine, Ranks& ranks);

} // namespace vfm
