/**
 * WriteObj: the closed surface of each material in text files of Wavefront OBJ (MaterialSkins).
 *
 * Surfaces of neighbours have the same vertices. Coordinates are written such that they are read
 * back as the same numbers.
 */
#pragma once

#include "Meshes/Surfaces/MaterialSkins.h"

namespace vfm
{

/// Writes the surface of each material as a group with its name; blanks in names become '_'.
/// @see WriteSkins
void WriteObj(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
