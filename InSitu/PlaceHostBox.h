/**
 * PlaceHostBox: the whole grid and this rank's place in it, from the bounding boxes that the ranks know.
 */
#pragma once

#include "Base/Ranks.h"
#include "HostGrid.h"

namespace vfm
{

/// The bounding box of a rank's cells (length units of the host) and how many there are along each axis.
struct BoundedCells
{
  Vector3 Lower, Upper;
  std::array<int, 3> Intervals;
};

/// Throws InputError on numbers that are not finite, a box that is flat or inside out, intervals below 1. Not collective.
void CheckBoundedCells(const BoundedCells& cells);

/// Collective: a grid with one box, without arrays, whose origin and spacing are those of all ranks' boxes together, so the
/// same bits on all ranks. Throws InputError, on all ranks alike, when cells differ in size or boxes are not on one grid,
/// by more than a thousandth of a cell.
HostGrid PlaceHostBox(const BoundedCells& mine, Ranks& ranks);

} // namespace vfm
