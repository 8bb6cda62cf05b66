/**
 * WriteDual: writes the polyhedra around the nodes of tetrahedra (DualMesh.h) as a mesh of OpenFOAM
 * or as VTK's XML file of polyhedra.
 *
 * OpenFOAM: patches, cell zones and face zones have the names of those of the tetrahedra
 * (FoamMesh.h). VTK: cells have MaterialId, FragmentId if fragments are known, GlobalCellIds from
 * 1, NodeId, the global id of the node inside, and the values of other arrays of points there;
 * fields are those of the tetrahedra.
 */
#pragma once

#include "Meshes/Files/OutputSet.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Checks that polyhedra can be made around the nodes of a mesh.
/// @param mesh  a whole mesh
/// @throws InputError  if it does not consist of linear tetrahedra that share their nodes
void RequireDual(const MeshData& mesh);

/// Writes constant/polyMesh in a folder.
/// @param mesh  a whole mesh, ordered by global id, for which RequireDual returns
/// @throws InputError  if it is periodic, if a number exceeds 2^31 - 1, or if a file cannot be
///   written
void WriteDualFoam(
  const MeshData& mesh, const std::string& folder, bool isBinary, OutputSet& files);

/// Writes a file .vtu.
/// @param mesh  a whole mesh, ordered by global id, for which RequireDual returns
/// @throws InputError  if the file cannot be written
void WriteDualVtu(const MeshData& mesh, const std::string& path, OutputSet& files);

} // namespace vfm
