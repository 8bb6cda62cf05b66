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
  AsUsual, ///< usual number of files of the format
  Single   ///< one file with the whole mesh, which rank 0 gathers
};

/// Returns all supported suffixes, for instance ".vtu".
std::vector<std::string> GetOutputSuffixes();
/// Returns the reason why a file of this name, or a single one, is not supported; "" if it is.
std::string FindOutputProblem(const std::string& path, OutputFiles files = OutputFiles::AsUsual);
/// Returns the reason why no file can be created in the folder of a path; "" if it can.
std::string FindFolderProblem(const std::string& path);

/// Writes a mesh. Number of files by suffix:
/// - .vtu: one file of the whole mesh, which rank 0 gathers
/// - .pvtu: one file, and one piece per rank that has elements
/// - .e, .ex2, .exo (Exodus): one file per rank, path.N.RANK for N > 1; one file if requested
/// - .inp (Abaqus): one file
/// @param mesh  part of this rank
/// @throws InputError  if the files cannot be written, on all ranks; contains path and reason
/// @pre Collective
void WriteMesh(const MeshData& mesh, const std::string& path, Ranks& ranks,
  OutputFiles files = OutputFiles::AsUsual);

} // namespace vfm
