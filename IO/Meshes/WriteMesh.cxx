#include "Meshes/WriteMesh.h"

#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "Meshes/WriteAbaqus.h"
#include "Meshes/WriteExodus.h"
#include "Meshes/WriteVtu.h"
#include "Ranks/WorkTogether.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace vfm
{
namespace
{

using Writer = void (*)(const MeshData&, const std::string& path, Ranks&);

struct Format
{
  const char* Suffix;
  Writer Write;       ///< function that writes the usual files; collective
  Writer WriteSingle; ///< function that writes one file from several ranks; null if not supported
};

template <ExodusParts parts>
void WriteExodusFiles(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteExodus(mesh, path, ranks, parts);
}

constexpr Writer WriteExodusParts = WriteExodusFiles<ExodusParts::OnePerRank>;
constexpr Writer WriteExodusFile = WriteExodusFiles<ExodusParts::One>;

constexpr Format Formats[] = { { ".vtu", WriteVtu, WriteVtu }, { ".pvtu", WritePvtu, nullptr },
  { ".e", WriteExodusParts, WriteExodusFile }, { ".ex2", WriteExodusParts, WriteExodusFile },
  { ".exo", WriteExodusParts, WriteExodusFile }, { ".inp", WriteAbaqus, WriteAbaqus } };

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

std::string FindOutputProblem(const std::string& path, OutputFiles files)
{
  const Format* format = FindFormat(path);
  if (!format)
  {
    return "The output " + path +
      " is of an unknown format. Supported formats: " + JoinTexts(GetOutputSuffixes()) + ".";
  }
  const bool isRejected = files == OutputFiles::Single && !format->WriteSingle;
  return isRejected ? "The output " + path + " always consists of several files." : "";
}

std::string FindFolderProblem(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  return access(folder.c_str(), W_OK | X_OK) == 0
    ? ""
    : "Cannot write the output " + path + ": " + std::strerror(errno) + ".";
}

void WriteMesh(const MeshData& mesh, const std::string& path, Ranks& ranks, OutputFiles files)
{
  WorkTogether(ranks,
    [&]
    {
      for (const std::string& problem : { FindOutputProblem(path, files), FindFolderProblem(path) })
      {
        if (!problem.empty())
        {
          throw InputError(problem);
        }
      }
      const Format& format = *FindFormat(path);
      const Writer write = files == OutputFiles::Single ? format.WriteSingle : format.Write;
      PrefixErrors("Cannot write the output " + path + ": ", [&] { write(mesh, path, ranks); });
    });
}

} // namespace vfm
