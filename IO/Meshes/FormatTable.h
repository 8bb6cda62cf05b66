/**
 * FormatTable: the formats of mesh files and their options, for all front ends and documents.
 *
 * describe_options prints the table for scripts/generate.
 */
#pragma once

#include "Meshes/Gmsh/WriteGmsh.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vfm
{

/// Choices among the forms of a format. Each one is an option of some formats.
struct OutputForm
{
  bool IsSingle = false; ///< one file with the whole mesh, which rank 0 gathers
  GmshVersion Version = GmshVersion::Automatic;
  bool IsBinary = false;      ///< binary instead of text
  bool HasInterfaces = true;  ///< whether the file has faces between elements
  bool IsReduced = false;     ///< C3D20R instead of C3D20
  bool IsPlaneStress = false; ///< elements of a plane have plane stress instead of plane strain
  bool IsDual = false;        ///< polyhedra around the nodes of tetrahedra
};

enum class MeshFormat
{
  Vtu,
  Pvtu,
  Exodus,
  Abaqus,
  LsDyna,
  Radioss,
  Nastran,
  Febio,
  Gmsh,
  Xdmf,
  Foam,
  Stl,
  Obj,
  Vtp,
  Lammps
};

struct FormatOption
{
  const char* Name;                   ///< in the Python package
  const char* Argument;               ///< of sculptor; empty: none
  const char* Value;                  ///< of the argument
  const char* Help;                   ///< for the argument
  bool (*IsGiven)(const OutputForm&); ///< null: not a part of OutputForm
  const char* Lack;                   ///< why a format without the option refuses it
  bool ListsFormats = true;           ///< whether formats that have it follow in the message
  bool IsOfWholeFiles = false;        ///< of all formats except IsPerRank, which do not list it
};

struct FormatRow
{
  MeshFormat Format;
  std::vector<std::string> Suffixes; ///< with dot, in lower case
  std::string Name;
  std::string Content;              ///< phrase for the help and the documents
  std::vector<std::string> Options; ///< names
  bool IsPerRank = false;           ///< whether ranks always write files of their own
  bool IsInPackage = true; ///< whether the Python package writes the format by its suffixes

  bool Has(const FormatOption& option) const;
};

/// Returns whether a choice among "strain" and "stress" is plane stress; nothing for other texts.
std::optional<bool> ParsePlaneStress(const std::string& name);

std::span<const FormatOption> GetFormatOptions();
const std::vector<FormatRow>& GetFormatTable();
/// Returns the format of a path, by its suffix, or null.
const FormatRow* FindMeshFormat(const std::string& path);

/// Returns the reason why a mesh cannot be written in this form to a file of this name; "" if it
/// can. Checks only the suffix and the form.
std::string FindOutputProblem(const std::string& path, const OutputForm& form = {});

} // namespace vfm
