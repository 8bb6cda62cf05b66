/**
 * FoamAddressing: the numbers of a rank's points, cells, faces and patches in the whole case, as
 * decomposePar writes them.
 */
#pragma once

#include "Meshes/OpenFoam/FoamMesh.h"

namespace vfm
{

struct FoamAddressing
{
  std::vector<Index> Points, Cells; ///< from 0
  std::vector<Index> Faces;         ///< from 1; negative if the face is reversed
  std::vector<Index> Patches;       ///< from 0; -1 for patches to other ranks
};

/// Finds the numbers in the case that a single rank writes (WriteFoam.h).
/// @pre Collective
FoamAddressing FindAddressing(const FoamMesh& foam, Ranks& ranks);

} // namespace vfm
