/**
 * ThreeMfFile: reads the objects of 3MF files.
 */
#pragma once

#include "Surfaces/ReadSurface.h"

namespace vfm
{

/// Reads a body for each item that the file builds: an object with its components, moved by their
/// transforms. Patches are the materials and colours of triangles, or else the objects.
/// @throws InputError  if the file is damaged, or an object refers to itself
std::vector<SurfaceFile> ReadThreeMf(const std::string& bytes, const SurfaceTools& tools);

} // namespace vfm
