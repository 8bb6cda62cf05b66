#include "Meshes/WriteMesh.h"

#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "Meshes/Decks/WriteAbaqus.h"
#include "Meshes/Decks/WriteLsDyna.h"
#include "Meshes/Decks/WriteNastran.h"
#include "Meshes/Decks/WriteRadioss.h"
#include "Meshes/Exodus/WriteExodus.h"
#include "Meshes/OpenFoam/WriteFoam.h"
#include "Meshes/Surfaces/WriteStl.h"
#include "Meshes/Vtk/WriteVtu.h"
#include "Meshes/Xdmf/WriteXdmf.h"
#include "Ranks/WorkTogether.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace vfm
{
namespace
{

using Writer = void (*)(const MeshData&, const std::string& path, Ranks&, const OutputForm&);

struct Format
{
  const char* Suffix;
  Writer Write;    ///< collective
  bool HasSingle;  ///< whether several ranks can write one file
  bool HasVersion; ///< whether OutputForm::Version and HasInterfaces apply
  bool HasBinary;  ///< whether OutputForm::IsBinary applies
};

/// Writes a format that has only one form.
template <void (*write)(const MeshData&, const std::string& path, Ranks&)>
void WritePlain(const MeshData& mesh, const std::string& path, Ranks& ranks, const OutputForm&)
{
  write(mesh, path, ranks);
}

void WriteExodusFiles(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const OutputForm& form)
{
  const bool isSingle = form.Files == OutputFiles::Single;
  WriteExodus(mesh, path, ranks, isSingle ? ExodusParts::One : ExodusParts::OnePerRank);
}

void WriteGmshFile(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const OutputForm& form)
{
  WriteGmsh(mesh, path, ranks, { form.Version, form.IsBinary, form.HasInterfaces });
}

void WriteFoamCase(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const OutputForm& form)
{
  WriteFoam(mesh, path, ranks, { form.Files == OutputFiles::Single, form.IsBinary });
}

void WriteAbaqusFile(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const OutputForm& form)
{
  WriteAbaqus(mesh, path, ranks, form.IsReduced);
}

constexpr Format Formats[] = {
  { ".vtu", WritePlain<WriteVtu>, true, false, false },
  { ".pvtu", WritePlain<WritePvtu>, false, false, false },
  { ".e", WriteExodusFiles, true, false, false },
  { ".ex2", WriteExodusFiles, true, false, false },
  { ".exo", WriteExodusFiles, true, false, false },
  { ".inp", WriteAbaqusFile, true, false, false },
  { ".k", WritePlain<WriteLsDyna>, true, false, false },
  { ".key", WritePlain<WriteLsDyna>, true, false, false },
  { ".rad", WritePlain<WriteRadioss>, true, false, false },
  { ".bdf", WritePlain<WriteNastran>, true, false, false },
  { ".nas", WritePlain<WriteNastran>, true, false, false },
  { ".msh", WriteGmshFile, true, true, true },
  { ".xdmf", WritePlain<WriteXdmf>, true, false, false },
  { ".foam", WriteFoamCase, true, false, true },
  { ".stl", WritePlain<WriteStl>, true, false, false },
};

/// Returns the suffixes of the formats with a property.
std::string ListSuffixes(bool Format::*property)
{
  std::vector<std::string> suffixes;
  for (const Format& format : Formats)
  {
    if (format.*property)
    {
      suffixes.emplace_back(format.Suffix);
    }
  }
  return JoinTexts(suffixes);
}

const Format* FindFormat(const std::string& path)
{
  const auto found = std::find_if(std::begin(Formats), std::end(Formats),
    [&path](const Format& format) { return HasSuffix(path, format.Suffix); });
  return found == std::end(Formats) ? nullptr : found;
}

} // namespace

std::vector<std::string> GetOutputSuffixes()
{
  std::vector<std::string> suffixes;
  for (const Format& format : Formats)
  {
    suffixes.emplace_back(format.Suffix);
  }
  return suffixes;
}

std::string FindOutputProblem(const std::string& path, const OutputForm& form)
{
  const Format* format = FindFormat(path);
  if (!format)
  {
    return "The output " + path +
      " is of an unknown format. Supported formats: " + JoinTexts(GetOutputSuffixes()) + ".";
  }
  if (form.Files == OutputFiles::Single && !format->HasSingle)
  {
    return "The output " + path + " always consists of several files.";
  }
  if (form.Version != GmshVersion::Automatic && !format->HasVersion)
  {
    return "The output " + path +
      " has no choice of version. Formats that have it: " + ListSuffixes(&Format::HasVersion) + ".";
  }
  if (!form.HasInterfaces && !format->HasVersion)
  {
    return "The output " + path +
      " has no faces of interfaces to leave out. Formats that have them: " +
      ListSuffixes(&Format::HasVersion) + ".";
  }
  if (form.IsBinary && !format->HasBinary)
  {
    return "The output " + path +
      " has no binary form. Formats that have it: " + ListSuffixes(&Format::HasBinary) + ".";
  }
  if (form.IsReduced && format->Write != WriteAbaqusFile)
  {
    return "The output " + path + " has no elements of reduced integration. Only .inp has them.";
  }
  return format->Write == WritePlain<WriteStl> ? FindStlProblem(path) : "";
}

std::string FindFolderProblem(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  return access(folder.c_str(), W_OK | X_OK) == 0
    ? ""
    : "Cannot write the output " + path + ": " + std::strerror(errno) + ".";
}

void WriteMesh(const MeshData& mesh, const std::string& path, Ranks& ranks, const OutputForm& form)
{
  WorkTogether(ranks,
    [&]
    {
      for (const std::string& problem : { FindOutputProblem(path, form), FindFolderProblem(path) })
      {
        if (!problem.empty())
        {
          throw InputError(problem);
        }
      }
      PrefixErrors("Cannot write the output " + path + ": ",
        [&] { FindFormat(path)->Write(mesh, path, ranks, form); });
    });
}

} // namespace vfm
