/**
 * WriteVtp: writes points, lines or polygons as VTK's XML file of polydata, .vtp.
 */
#pragma once

#include "Meshes/Files/OutputSet.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Writes a file of a set.
/// @param cells  elements with 1 corner (vertices), 2 (lines), or 3 and 4 (polygons)
/// @throws InputError  if the file cannot be written; contains the reason
void WriteVtp(const MeshData& cells, const std::string& path, OutputSet& files);

} // namespace vfm
