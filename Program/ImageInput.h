/**
 * ImageInput: reads images of labels or fractions, and voxels.
 */
#pragma once

#include "Arguments.h"
#include "Input.h"

namespace vfm
{

/// Returns the suffixes of voxel files, for instance ".npy".
std::vector<std::string> GetVoxelSuffixes();
/// Tests whether a path has a suffix of voxel files.
bool IsVoxelFile(const std::string& path);

/// Reads a voxel file (IsVoxelFile) or an image (IsImageFile); each rank gets a slab.
/// @throws InputError  (UnreadableInput) if the file cannot be read
/// @pre Collective
Input ReadImage(const Arguments& arguments, Ranks& ranks);

} // namespace vfm
