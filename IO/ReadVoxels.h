/**
 * ReadVoxels: the values of a voxel file in a box of its cells.
 */
#pragma once

#include "TypedValues.h"
#include "VoxelFile.h"

#include <vector>

namespace vfm
{

/// A value a cell of the box, x fastest. Labels: one array 'MaterialId' of the narrowest type that holds those of the
/// file's type, int for text. Fractions: 'VolumeFraction', or 'VolumeFraction1', 'VolumeFraction2', ... of a 4-D array.
/// Only the box is kept in memory.
///
/// Throws InputError, without the path: Cells are not told, the number of values is another, a value is no whole number, negative
/// or over 2^31 - 1. All values that can be wrong are read, whatever the box: processes that read parts of a file
/// fail alike.
std::vector<TypedValues> ReadVoxels(const VoxelFile& file, const IndexBox& box);

} // namespace vfm
