/**
 * ReadLabelText: reads labels from a text of integers separated by white space.
 */
#pragma once

#include "VoxelFile.h"

namespace vfm
{

/// Checks that the size of the image is known and that the file is long enough for it.
/// @throws InputError  if file.Cells is not set, or if the file is too short for one value per
///   cell; the message contains the number of values found, but not the path
void CheckLabelCount(const VoxelFile& file);

/// Reads the labels of a box of cells. The text is always read to its end, so that errors do not
/// depend on the box.
/// @param file  voxel file whose Cells are set
/// @param box  cells to read, global indices
/// @param[out] labels  one label per cell of the box, x fastest
/// @throws InputError  if a value is not a label (the message contains its line), or if there are
///   too few or too many values; the message does not contain the path
void ReadLabelText(const VoxelFile& file, const IndexBox& box, int* labels);

} // namespace vfm
