/**
 * ReadVoxels: reads the values of a voxel file in a box of its cells.
 */
#pragma once

#include "TypedValues.h"
#include "VoxelFile.h"

#include <vector>

namespace vfm
{

/// Reads the values of a voxel file in a box of its cells. Only the box is stored. All values that
/// may be invalid are read and checked, even outside the box: ranks that read parts of the same
/// file fail with the same error.
/// @param file  result of InspectVoxels
/// @param box  cells to read, global indices
/// @return arrays with one value per cell of the box, x fastest. Labels: one array 'MaterialId', of
///   the narrowest type that holds every label of the file's type; int for text. Fractions:
///   'VolumeFraction'; of a 4-D array 'VolumeFraction1', 'VolumeFraction2', ...
/// @throws InputError  if file.Cells is not set, the number of values differs from the number of
///   cells, or a label is not an integer from 0 to 2^31 - 1; the message does not contain the path
std::vector<TypedValues> ReadVoxels(const VoxelFile& file, const IndexBox& box);

} // namespace vfm
