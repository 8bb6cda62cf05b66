/**
 * BlockChecks: what the blocks of one grid must be: apart, without gaps, not too many cells.
 */
#pragma once

#include "Input/InputBlocks.h"

namespace vfm
{

/// Collective: the places of the blocks of all ranks, by rank.
std::vector<BlockPlace> GatherPlaces(const std::vector<InputBlock>& blocks, Ranks& ranks);

/// Throws InputError when two places share a cell. isAlone: one rank, for messages.
void CheckOverlaps(std::vector<BlockPlace> places, bool isAlone);

/// Throws InputError when the places, which do not overlap, do not fill the grid.
void CheckGaps(const InputBlocks& input);

/// Throws InputError when the grid has more nodes than ids can number.
void CheckIds(const InputBlocks& input);

} // namespace vfm
