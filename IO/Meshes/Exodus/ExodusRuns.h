/**
 * ExodusRuns: values of Exodus variables of a mesh that leaves out hexes, part by part.
 */
#pragma once

#include "Meshes/Exodus/NetcdfLayout.h"
#include "Meshes/Files/RunValues.h"

namespace vfm
{

/// The functions return no function if the mesh is null, which means that no hexes are left out.
/// Values of elements are those of one material, the elements of a block.
/// @param mesh  must outlive the results
///@{
NetcdfParts PartsOfCoordinates(const MeshWithRuns* mesh, int axis);
NetcdfParts PartsOfNodes(const MeshWithRuns* mesh, int material);
NetcdfParts PartsOfPointArray(const MeshWithRuns* mesh, const MeshArray& array);
NetcdfParts PartsOfElementArray(const MeshWithRuns* mesh, const MeshArray& array, int material);
NetcdfParts PartsOfPointIds(const MeshWithRuns* mesh, const MeshData& stored);
/// @param materials  of the blocks
NetcdfParts PartsOfElementIds(
  const MeshWithRuns* mesh, const MeshData& stored, std::vector<int> materials);
///@}

} // namespace vfm
