/**
 * HiddenCells: cells below boxes of finer levels, which whoever draws or sums the grid leaves out.
 */
#pragma once

#include "HostGrid.h"
#include "Ranks/Ranks.h"

namespace vfm
{

///@{ Of VTK: the array of marks, and bits in it: a copy of another box's cell; a cell that does not count.
constexpr const char* GhostTypeName = "vtkGhostType";
constexpr unsigned char DuplicateCell = 1, HiddenCell = 32;
///@}

/// Cells that no other box of its level has.
struct HostPlace
{
  IndexBox Cells;
  Index Level; // no padding is sent
};

/// The boxes of all ranks, by rank.
struct HostPlaces
{
  std::vector<HostPlace> All;
  std::size_t First = 0; ///< of this rank
  std::size_t Most = 0;  ///< boxes on any rank
};

/// Collective.
HostPlaces GatherHostPlaces(const HostGrid& grid, Ranks& ranks);

/// The marks of the box's cells, the host's own among them, when boxes of finer levels cover some; else none.
std::vector<unsigned char> HideCovered(const HostBox& box, const HostPlaces& places);

} // namespace vfm
