/**
 * PlyFile: reads the polygons of PLY files (Stanford), text or binary.
 */
#pragma once

#include "Surfaces/ReadSurface.h"

#include <string_view>

namespace vfm
{

/// Reads points (x, y, z) and faces (vertex_indices, vertex_index); other elements and properties
/// are skipped.
/// @throws InputError  if it is damaged or truncated
SurfaceFile ReadPly(std::string_view bytes);

} // namespace vfm
