/**
 * WriteMesh: writes the mesh of all ranks to files, in the format of the suffix.
 */
#pragma once

#include "Elements/MeshWithRuns.h"
#include "Meshes/FormatTable.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Returns the reason why no file can be created in the folder of a path; "" if one can.
std::string FindFolderProblem(const std::string& path);

/// Returns the path of the file in which WriteMesh writes the particles of a mesh, if files of the
/// format hold none; "" if they do.
std::string FindParticlesBeside(const std::string& path);

/// Writes a mesh as FormatTable says: mostly one file of the whole mesh, which rank 0 gathers.
/// @param mesh  part of this rank
/// @throws InputError  if the files cannot be written, on all ranks; contains path and reason
/// @pre Collective
void WriteMesh(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const OutputForm& form = {});

/// Returns whether WriteMesh can write the format of a path from a mesh that leaves hexes out.
bool TakesRuns(const std::string& path);

/// Writes the same files as for a mesh with all hexes, of a mesh on one rank.
/// @param mesh  without particles and cohesive elements
/// @param whole  the mesh with these hexes
/// @throws InputError  if the file cannot be written; contains path and reason
/// @pre TakesRuns(path)
void WriteMesh(const MeshData& mesh, const MeshWithRuns& whole, const std::string& path);

} // namespace vfm
