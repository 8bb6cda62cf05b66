/**
 * WriteMesh: writes the mesh of all ranks to files, in the format of the suffix.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

#include <string>
#include <vector>

namespace vfm
{

enum class OutputFiles
{
  AsUsual, ///< the usual number of files of the format (WriteMesh)
  Single   ///< one file with the whole mesh, which rank 0 gathers
};

/// Returns all supported suffixes, for instance ".vtu".
std::vector<std::string> GetOutputSuffixes();
/// Returns the reason why a mesh cannot be written to a file of this name, or to a single file of
/// this name; "" if it can. Checks only the suffix and `files`.
std::string FindOutputProblem(const std::string& path, OutputFiles files = OutputFiles::AsUsual);
/// Returns the reason why no file can be created in the folder of a path; "" if one can.
std::string FindFolderProblem(const std::string& path);

/// Writes a mesh. The suffix determines the number of files:
/// - .vtu: one file of the whole mesh, which rank 0 gathers
/// - .pvtu: the file itself, and one .vtu file per rank that has elements; OutputFiles::Single is
///   not supported
/// - .e, .ex2, .exo (Exodus): one file per rank, path.N.RANK for N > 1 ranks; one file of the whole
///   mesh with OutputFiles::Single
/// - .inp (Abaqus): one file of the whole mesh
/// @param mesh  part of this rank
/// @throws InputError  if the files cannot be written, on all ranks; contains path and reason
/// @pre Collective
void WriteMesh(const MeshData& mesh, const std::string& path, Ranks& ranks,
  OutputFiles files = OutputFiles::AsUsual);

} // namespace vfm
