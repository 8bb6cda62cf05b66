/**
 * CaretNames: names of labels in the header extension of Caret, as Connectome Workbench and
 * TotalSegmentator write them into NIfTI files.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Input/LabelNames.h"

#include <string>

namespace vfm
{

/// Reads the names of labels from the extensions of a NIfTI file.
/// @param begin,end  places of the extensions in the file after decompression, bytes; the first
///   four bytes say whether there are any
/// @param isSwapped  true: integers have the other byte order
/// @param volume  number of the image; a table of another image is used only if it is the first and
///   the image has no table
/// @param warning  set if the extensions are damaged
LabelNames ReadCaretNames(const std::string& path, Index begin, Index end, bool isSwapped,
  Index volume, std::string& warning);

} // namespace vfm
