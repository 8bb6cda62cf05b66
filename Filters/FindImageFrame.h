/**
 * FindImageFrame: finds the axes of VTK images.
 */
#pragma once

#include "Input/ImageFrame.h"

#include <vector>

namespace vfm
{

struct InputPart;

/// Returns the common frame of the images of all ranks; the identity for other grids.
/// @throws InputError if direction matrices are not orthonormal, or differ; on all ranks
/// @pre Collective
ImageFrame FindImageFrame(const std::vector<InputPart>& parts, Ranks& ranks);

} // namespace vfm
