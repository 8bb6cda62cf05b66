/**
 * HostInput: a HostGrid as the input of a run of the mesher, without a copy.
 */
#pragma once

#include "HostGrid.h"
#include "Input/InputBlocks.h"

namespace vfm
{

/// The boxes of this rank as blocks. Coordinates are the same bits on every rank, and on every level that has the node. The arrays are the
/// host's memory.
CollectedBlocks CollectHostBlocks(const HostGrid& grid, const Ranks& ranks);

} // namespace vfm
