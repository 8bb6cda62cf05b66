/**
 * BlockChecks: checks that blocks tile one grid, and that 64-bit ids can number its nodes.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <span>

namespace vfm
{

/// Sets the Places of the levels of a grid: the blocks of this rank, and the blocks of other ranks
/// that have common cells with them, also on other levels.
/// @pre Collective
void FindPlaces(std::span<InputBlocks> levels, Ranks& ranks);

/// Checks that places do not overlap.
/// @param isAlone whether there is only one rank; messages then name no ranks
/// @throws InputError naming two blocks and a common cell
void CheckOverlaps(const std::vector<BlockPlace>& places, bool isAlone);

/// Checks that the blocks of each level do not overlap.
/// @throws InputError as above, for the coarsest level with overlaps, on all ranks
/// @pre Collective; Places are set (FindPlaces)
void CheckOverlaps(std::span<const InputBlocks> levels, Ranks& ranks);

/// Checks that the blocks of all ranks fill the grid.
/// @throws InputError naming the first cell without a block, on all ranks
/// @pre Collective; blocks do not overlap
void CheckGaps(const InputBlocks& input, Ranks& ranks);

/// Checks that 64-bit ids can number all nodes of the grid.
/// @throws InputError that states the number of nodes
void CheckIds(const InputBlocks& input);

} // namespace vfm
