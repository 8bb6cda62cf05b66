/**
 * FlatSurfaces: surfaces of an input as a few arrays, for field data, messages and Python.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Surfaces/InputSurfaces.h"

namespace vfm
{

/// Bodies one after the other. Patches are numbered through all bodies.
struct FlatSurfaces
{
  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;
  std::vector<int> Bodies;             ///< body of each triangle, from 0, ascending
  std::vector<int> Patches;            ///< patch of each triangle, from 0
  std::vector<std::string> Names;      ///< of the bodies
  std::vector<std::string> PatchNames; ///< of the patches; texts may be empty
};

FlatSurfaces FlattenSurfaces(const InputSurfaces& surfaces);

/// Makes the bodies by MakeBody.
/// @throws InputError  if arrays do not fit each other, or if MakeBody does
InputSurfaces RestoreSurfaces(const FlatSurfaces& flat);

/// Returns, on all ranks, the surfaces of the lowest rank that has triangles.
/// @pre Collective
FlatSurfaces ShareSurfaces(FlatSurfaces mine, Ranks& ranks);

} // namespace vfm
