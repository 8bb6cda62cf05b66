/**
 * WriteGmsh: writes a mesh in the format of Gmsh, MSH 2.2 or 4.1.
 *
 * Contents of a file:
 * - hexahedra or tetrahedra, in physical groups of the materials with their names and ids
 * - quadrilaterals or triangles on the sides of the domain and on all interfaces, each face once,
 *   in physical groups with names and ids of NamedSurfaces.h; normals point away from the element
 *   that owns the face
 * - nodes and elements with their global ids; faces have the ids after the greatest of an element
 * - elementary entities: volumes are fragments, surfaces, curves and vertices those of the mesh
 * - in version 4.1, pairs of nodes on opposite sides of periodic meshes (GmshPeriodic.h)
 *
 * In version 2.2 an element is in one group, so a face is in the finest: the side of the domain,
 * the smooth side, or the interface. Version 4.1 has all groups and the entities with their bounds.
 * Groups without elements are left out. Particles are in NAME_particles.vtp: points as elements
 * would be boundaries of dimension 0 for readers.
 *
 * C. Geuzaine and J.-F. Remacle, Int. J. Numer. Methods Eng. 79 (2009) 1309-1331; format: Gmsh
 * reference manual 4.13, sections "MSH file format" and "MSH file format version 2 (Legacy)".
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <optional>
#include <string>

namespace vfm
{

enum class GmshVersion
{
  Automatic, ///< 2.2, or 4.1 if an id exceeds 2^31 - 1
  V2_2,
  V4_1
};

/// Form of a file.
struct GmshForm
{
  GmshVersion Version = GmshVersion::Automatic;
  bool IsBinary = false;
  bool HasInterfaces = true; ///< whether the file has faces between elements; deal.II refuses them
};

/// Returns the version with a name, "2.2" or "4.1", or nothing.
std::optional<GmshVersion> ParseGmshVersion(const std::string& name);

/// Writes one file on rank 0. Its contents do not depend on the number of ranks.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @throws InputError  if the mesh is empty or lacks a required array, if version 2.2 cannot hold
///   its ids, or if the file cannot be written; on all ranks. The earlier file then remains
/// @pre Collective
/// @note Rank 0 needs the memory of GatherMesh.
void WriteGmsh(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const GmshForm& form = {});

} // namespace vfm
