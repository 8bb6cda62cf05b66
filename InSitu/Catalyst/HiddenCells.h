/**
 * HiddenCells: marks cells below boxes of finer levels, which pictures and sums must skip.
 */
#pragma once

#include "HostGrid.h"
#include "Ranks/Ranks.h"

namespace vfm
{

///@{ Name and bits of VTK's array of marks: DuplicateCell for a copy of a cell of another box,
/// HiddenCell for a cell that is skipped.
constexpr const char* GhostTypeName = "vtkGhostType";
constexpr unsigned char DuplicateCell = 1, HiddenCell = 32;
///@}

/// Cells of a box that no other box of its level has.
struct HostPlace
{
  IndexBox Cells;
  Index Level; // an Index, so that the struct is sent without padding
};

/// Boxes of all ranks, by rank.
struct HostPlaces
{
  std::vector<HostPlace> All;
  std::size_t First = 0; ///< index of the first box of this rank
  std::size_t Most = 0;  ///< largest number of boxes per rank
};

/// Gathers the boxes of all ranks.
/// @pre Collective
HostPlaces GatherHostPlaces(const HostGrid& grid, Ranks& ranks);

/// Returns the marks of a box's cells if finer boxes cover some of them; otherwise an empty list.
/// Marks of the simulation are included.
std::vector<unsigned char> HideCovered(const HostBox& box, const HostPlaces& places);

} // namespace vfm
