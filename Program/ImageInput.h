/**
 * ImageInput: images of labels or fractions, and voxels, that IO reads.
 */
#pragma once

#include "Arguments.h"
#include "Input.h"

namespace vfm
{

/// Such as ".npy".
std::vector<std::string> GetVoxelSuffixes();
bool IsVoxelFile(const std::string& path);

/// Collective: a file of voxels (IsVoxelFile) or an image (IsImageFile), of which each rank reads a slab. Throws InputError
/// (UnreadableInput).
Input ReadImage(const Arguments& arguments, Ranks& ranks);

} // namespace vfm
