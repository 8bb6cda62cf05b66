/**
 * WriteVtu: writes a mesh as VTK's XML files of unstructured grids, .vtu and .pvtu.
 *
 * Files contain all arrays of points and elements and all fields. GlobalPointIds and GlobalCellIds
 * are marked as global ids, MaterialId as scalars. The field TimeValue holds the time. Values are
 * inline and binary, compressed if the build has zlib. Particles are in NAME_particles.vtp, also
 * those of .pvtu in one file.
 */
#pragma once

#include "Elements/MeshWithRuns.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Writes one file on rank 0. Its contents do not depend on the number of ranks.
/// @param mesh  part of this rank
/// @throws InputError  if the parts do not form one mesh, or if the file cannot be written; on all
///   ranks. The message holds the reason, not the path. The earlier file then remains
/// @pre Collective
/// @note Rank 0 needs the memory of GatherMesh.
void WriteVtu(const MeshData& mesh, const std::string& path, Ranks& ranks);

/// Writes the same file of a mesh on one rank, without holding the hexes that the mesh leaves out.
/// @param whole  the mesh with these hexes
void WriteVtu(const MeshData& mesh, const MeshWithRuns& whole, const std::string& path);

/// Writes one file of the polyhedra around the nodes of tetrahedra (WriteDual.h) on rank 0, in the
/// same way.
/// @throws InputError  also if polyhedra are not made of the mesh
void WritePolyhedra(const MeshData& mesh, const std::string& path, Ranks& ranks);

/// Writes the file NAME.pvtu, and one file NAME/NAME_RANK.vtu per rank that has elements.
/// @param mesh  part of this rank
/// @param path  path of NAME.pvtu
/// @throws InputError  same conditions as WriteVtu
/// @pre Collective
void WritePvtu(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
