/**
 * WriteMesh: the mesh of all ranks as files, of the format that the suffix names.
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
  AsUsual, ///< of the format
  Single   ///< one of the whole mesh, which rank 0 gathers
};

/// Such as ".vtu".
std::vector<std::string> GetOutputSuffixes();
/// Says why files of that name are not written, or not as a single one; "" where they are.
std::string FindOutputProblem(const std::string& path, OutputFiles files = OutputFiles::AsUsual);
/// Says why no file can be made in the folder of the path; "" where one can.
std::string FindFolderProblem(const std::string& path);

/// Collective: .vtu, one file of the whole mesh, which rank 0 gathers; .pvtu with one piece per rank; .e, .ex2, .exo of Exodus, one
/// file per rank (path.N.RANK when there are several) unless a single one is requested; .inp of Abaqus, one file. mesh: this rank's
/// part. Throws InputError on all ranks, with the path and the reason.
void WriteMesh(const MeshData& mesh, const std::string& path, Ranks& ranks,
  OutputFiles files = OutputFiles::AsUsual);

} // namespace vfm
