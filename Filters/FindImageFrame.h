/**
 * FindImageFrame: the axes of images of VTK.
 */
#pragma once

#include "Input/ImageFrame.h"

#include <vector>

namespace vfm
{

struct InputPart;

/// Collective: of the images of all ranks; of grids of other kinds the identity. Throws InputError, on all ranks alike, on
/// matrices that are not orthonormal, or that differ.
ImageFrame FindImageFrame(const std::vector<InputPart>& parts, Ranks& ranks);

} // namespace vfm
