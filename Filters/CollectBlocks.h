/**
 * CollectBlocks: the blocks of a VTK data object on this rank, alone: nothing here communicates.
 */
#pragma once

#include "InputBlocks.h"

namespace vfm
{

/// For messages. number: of the block in a composite data set, or -1 for an input that is no composite.
std::string NameBlock(int number, int rank, bool isAlone);

/// The blocks that have cells which are no ghosts, with all but Box set. input: null for none. Throws InputError on data of another
/// kind, flat grids, rotated images, coordinates that do not increase, ghost cells in the middle of a block, and as
/// RecogniseGrid does.
std::vector<InputBlock> CollectBlocks(vtkDataObject* input, int rank, bool isAlone);

} // namespace vfm
