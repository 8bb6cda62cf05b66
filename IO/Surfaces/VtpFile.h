/**
 * VtpFile: reads the polygons of XML files of VTK (.vtp).
 */
#pragma once

#include "Surfaces/ReadSurface.h"

namespace vfm
{

/// Reads polygons and triangle strips of all pieces: text, base64 or raw bytes, also compressed by
/// zlib.
/// @throws InputError  if the file is damaged, or compressed otherwise
SurfaceFile ReadVtp(const std::string& bytes, const SurfaceTools& tools);

} // namespace vfm
