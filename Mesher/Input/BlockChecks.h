/**
 * BlockChecks: checks that blocks tile one grid, and that 64-bit ids can number its nodes.
 */
#pragma once

#include "Input/InputBlocks.h"

namespace vfm
{

/// Returns the places of the blocks of all ranks, ordered by rank.
/// @pre Collective
std::vector<BlockPlace> GatherPlaces(const std::vector<InputBlock>& blocks, Ranks& ranks);

/// Checks that places do not overlap.
/// @param isAlone whether there is only one rank; messages then name no ranks
/// @throws InputError naming two blocks and a common cell
void CheckOverlaps(std::vector<BlockPlace> places, bool isAlone);

/// Checks that the places fill the grid.
/// @throws InputError naming the first cell without a block
/// @pre places do not overlap
void CheckGaps(const InputBlocks& input);

/// Checks that 64-bit ids can number all nodes of the grid.
/// @throws InputError that states the number of nodes
void CheckIds(const InputBlocks& input);

} // namespace vfm
