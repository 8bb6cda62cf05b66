/**
 * FoamFolder: writes the files of one mesh of OpenFOAM, and those of a case without a mesh.
 */
#pragma once

#include "Meshes/Files/OutputSet.h"
#include "Meshes/OpenFoam/FoamAddressing.h"

#include <functional>
#include <string>

namespace vfm
{

class FoamFile;

/// The lists of one mesh. The objects that it views must outlive it.
struct FoamLists
{
  const double* Points;
  Index NumberOfPoints, NumberOfCells, NumberOfFaces;
  std::function<void(FoamFile&)> AddFaces; ///< adds the list of the faces' points
  std::function<Index(Index)> OwnerOf;     ///< cell that owns a face
  const std::vector<Index>& Neighbours;    ///< neighbour of each inner face
  const std::vector<FoamPatch>& Patches;
  const std::vector<FoamZone>&CellZones, &FaceZones;
  int Rank = 0;
};

/// Writes constant/polyMesh in a folder.
void WritePolyMesh(
  const FoamLists& lists, const std::string& folder, bool isBinary, OutputSet& files);

/// Writes constant/polyMesh in a folder, of hexahedra or tetrahedra.
/// @param addressing  null: no addressing
void WritePolyMesh(const FoamMesh& foam, const FoamAddressing* addressing,
  const std::string& folder, bool isBinary, OutputSet& files);

/// Writes the dictionaries in the folder system that do not exist, and the empty file of the path.
/// @param ranks  number of meshes of the case
void WriteCaseFiles(
  const std::string& folder, const std::string& path, int ranks, OutputSet& files);

} // namespace vfm
