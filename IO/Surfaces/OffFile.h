/**
 * OffFile: reads the polygons of OFF files (Geomview).
 */
#pragma once

#include "Surfaces/ReadSurface.h"

#include <string_view>

namespace vfm
{

/// Reads text in the format OFF, also COFF, NOFF and CNOFF. Colours and normals are ignored.
/// @throws InputError  if it is damaged, binary, or of more than three dimensions
SurfaceFile ReadOff(std::string_view bytes);

} // namespace vfm
