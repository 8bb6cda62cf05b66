/**
 * HostInput: converts a HostGrid to the input of the mesher without copying its values.
 */
#pragma once

#include "HostGrid.h"
#include "Input/InputBlocks.h"

namespace vfm
{

/// Returns the boxes of this rank as blocks. Their arrays are the memory of the host. The
/// coordinates of a node are bitwise identical on all ranks and levels.
/// @throws InputError  if a block is not valid
CollectedBlocks CollectHostBlocks(const HostGrid& grid, const Ranks& ranks);

} // namespace vfm
