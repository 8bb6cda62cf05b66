/**
 * FoamPatches: the patches and zones of a mesh of OpenFOAM.
 */
#pragma once

#include "Meshes/OpenFoam/FoamSurfaces.h"
#include "Report/UniqueNames.h"

namespace vfm
{

struct FoamPatch
{
  std::string Name, Type;
  std::string Group;         ///< name of a patch group; empty: none
  Index Count = 0;           ///< number of faces
  int Neighbour = -1;        ///< rank behind the patch; -1: none
  std::string Opposite = {}; ///< name of the other patch of a cyclic pair
  std::string Refer = {};    ///< cyclic patch whose faces have copies on rank Neighbour
};

struct FoamZone
{
  std::string Name;
  std::vector<Index> Members;  ///< cells or faces, ascending
  std::vector<char> IsFlipped; ///< of each face: whether it is oriented against the zone
};

/// Returns a patch without faces for each surface, then one for faces on no surface.
/// @param[in,out] used  names of other patches
std::vector<FoamPatch> ListPatches(const FoamSurfaces& surfaces, UniqueNames& used);

/// Removes the patch groups that have the name of a patch, which OpenFOAM forbids: an interface
/// with smooth sides and other faces.
void RemoveEqualGroups(std::vector<FoamPatch>& patches);

} // namespace vfm
