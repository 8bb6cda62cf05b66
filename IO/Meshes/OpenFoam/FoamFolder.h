/**
 * FoamFolder: writes the files of one mesh of OpenFOAM, and those of a case without a mesh.
 */
#pragma once

#include "Meshes/Files/OutputSet.h"
#include "Meshes/OpenFoam/FoamAddressing.h"

#include <string>

namespace vfm
{

/// Writes constant/polyMesh in a folder.
/// @param addressing  null: no addressing
void WritePolyMesh(const FoamMesh& foam, const FoamAddressing* addressing,
  const std::string& folder, bool isBinary, OutputSet& files);

/// Writes the dictionaries in the folder system that do not exist, and the empty file of the path.
/// @param ranks  number of meshes of the case
void WriteCaseFiles(
  const std::string& folder, const std::string& path, int ranks, OutputSet& files);

} // namespace vfm
