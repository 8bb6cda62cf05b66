/**
 * CollectBlocks: the blocks of a VTK data object on this rank, alone: nothing here communicates.
 */
#pragma once

#include "InputBlocks.h"

namespace vfm
{

/// For messages. number: of the block in a composite data set, or -1 for an input that is no composite.
std::string NameBlock(int number, int rank, bool isAlone);

/// A data object that is no composite.
struct InputPart
{
  vtkDataObject* Data;
  int Number;       ///< in a composite data set, else -1
  std::string Name; ///< for messages
  bool IsPiece;     ///< of an input that is dealt to several ranks: it may be flat or empty

  /// What has none has no cells either, and on a rank that has nothing may be without all else.
  bool HasPoints() const;
};

/// input: null for none.
std::vector<InputPart> FindParts(vtkDataObject* input, int rank, bool isAlone);

/// The blocks that have cells which are no ghosts, with all but Box set. Throws InputError on data of another
/// kind, flat grids, points of grids that are no images, coordinates that do not increase, ghost cells in the middle of a block, and as
/// RecogniseGrid does.
std::vector<InputBlock> CollectBlocks(
  const std::vector<InputPart>& parts, const InputReading& reading);

} // namespace vfm
