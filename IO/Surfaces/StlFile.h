/**
 * StlFile: reads the triangles of STL files, text or binary.
 */
#pragma once

#include "Surfaces/ReadSurface.h"

#include <string_view>

namespace vfm
{

/// Reads text with one or several solids, which are patches, or binary triangles. Colours of
/// VisCAM and Materialise Magics are patches. Bytes behind the triangles are ignored, with a note.
/// @throws InputError  if the bytes are not an STL file, or are truncated
SurfaceFile ReadStl(std::string_view bytes);

} // namespace vfm
