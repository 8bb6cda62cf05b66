/**
 * WriteMesh: writes the mesh of all ranks to files, in the format of the suffix.
 */
#pragma once

#include "Meshes/Gmsh/WriteGmsh.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>
#include <vector>

namespace vfm
{

enum class OutputFiles
{
  AsUsual, ///< the usual number of files of the format (WriteMesh)
  Single   ///< one file with the whole mesh, which rank 0 gathers
};

/// Choices among the forms of a format.
struct OutputForm
{
  OutputFiles Files = OutputFiles::AsUsual;
  GmshVersion Version = GmshVersion::Automatic; ///< only for .msh
  bool IsBinary = false;     ///< binary instead of text; only for formats that have both
  bool HasInterfaces = true; ///< whether a .msh file has faces between elements
  bool IsReduced = false;    ///< C3D20R instead of C3D20; only for .inp
};

/// Returns all supported suffixes, for instance ".vtu".
std::vector<std::string> GetOutputSuffixes();
/// Returns the reason why a mesh cannot be written in this form to a file of this name; "" if it
/// can. Checks only the suffix and the form.
std::string FindOutputProblem(const std::string& path, const OutputForm& form = {});
/// Returns the reason why no file can be created in the folder of a path; "" if one can.
std::string FindFolderProblem(const std::string& path);

/// Writes a mesh. The suffix determines the number of files:
/// - .vtu: one file of the whole mesh, which rank 0 gathers
/// - .pvtu: the file itself, and one .vtu file per rank that has elements; OutputFiles::Single is
///   not supported
/// - .e, .ex2, .exo (Exodus): one file per rank, path.N.RANK for N > 1 ranks; one file of the whole
///   mesh with OutputFiles::Single
/// - .inp (Abaqus), .k, .key (LS-DYNA), .rad (OpenRadioss), .bdf, .nas (Nastran), .msh (Gmsh): one
///   file of the whole mesh
/// - .xdmf: one file of the whole mesh, and one of its facets, NAME_facets.xdmf
/// - .foam (OpenFOAM): the folder of the file is the case, with one mesh per rank, or one whole
///   mesh with OutputFiles::Single
/// - .stl: only the surfaces of the materials, in one file, or with {} in the name in one file per
///   material
/// @param mesh  part of this rank
/// @throws InputError  if the files cannot be written, on all ranks; contains path and reason
/// @pre Collective
void WriteMesh(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const OutputForm& form = {});

} // namespace vfm
