/**
 * ObjFile: reads the polygons of Wavefront OBJ files.
 */
#pragma once

#include "Surfaces/ReadSurface.h"

#include <string_view>

namespace vfm
{

/// Reads points and faces. Patches are the materials (usemtl) if there are several, else the groups
/// (g), else the objects (o).
/// @throws InputError  if a number is damaged, or a face refers to a point that does not exist
SurfaceFile ReadObj(std::string_view bytes);

} // namespace vfm
