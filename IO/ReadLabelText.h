/**
 * ReadLabelText: labels from text, whole numbers with any white space between them.
 */
#pragma once

#include "VoxelFile.h"

namespace vfm
{

/// Throws InputError, without the path, when Cells are not told, or when the file is too short for as many values; both
/// tell how many it holds.
void CheckLabelCount(const VoxelFile& file);

/// The labels of the cells of a box, x fastest. The text is read to its end, whatever the box. Throws InputError, without
/// the path, with the line of a value that is no label, or when there are too few or too many.
void ReadLabelText(const VoxelFile& file, const IndexBox& box, int* labels);

} // namespace vfm
