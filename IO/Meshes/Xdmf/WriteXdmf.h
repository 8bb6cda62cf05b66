/**
 * WriteXdmf: writes a mesh as XDMF for dolfinx, as text in two files.
 *
 * - NAME.xdmf, grid "mesh": the elements with the array MaterialId
 * - NAME_facets.xdmf, grid "facets": the faces on sides of the domain and interfaces, each once,
 *   with the array SurfaceId, the id of the finest named surface (TagFaces)
 *
 * Particles are in NAME_particles.vtp: dolfinx has no use for a grid of points.
 *
 * dolfinx reads the first array of a grid as tags, so there is no other array. Both files have all
 * points, because corners of facets are numbers of the points of the mesh. Points and elements are
 * in the order of their global ids. Normals of facets point away from the element that owns them.
 *
 * Names are in an Information element of the grid, MaterialNames or SurfaceNames: its value is an
 * object of JSON with the number of each name, its text the same as XML in the form of meshio.
 *
 * Format: https://www.xdmf.org/index.php/XDMF_Model_and_Format, version 3.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Writes the two files on rank 0. Their contents do not depend on the number of ranks.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @param path  NAME.xdmf
/// @throws InputError  if the mesh is empty or lacks a required array, or if a file cannot be
///   written; on all ranks. The earlier files then remain
/// @pre Collective
/// @note Rank 0 needs the memory of GatherMesh.
void WriteXdmf(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
