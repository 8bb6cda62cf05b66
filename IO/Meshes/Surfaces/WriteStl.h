/**
 * WriteStl: the closed surface of each material in text files of STL (MaterialSkins).
 *
 * Coordinates are written such that they are read back as the same numbers.
 */
#pragma once

#include "Meshes/Surfaces/MaterialSkins.h"

namespace vfm
{

/// Writes the surface of each material as a solid with its name.
/// @see WriteSkins
void WriteStl(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
