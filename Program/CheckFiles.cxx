#include "CheckFiles.h"

#include "Blocks/BlockFile.h"
#include "Images/Pictures/SliceFiles.h"
#include "Meshes/Files/OutputPlace.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <filesystem>

namespace vfm
{
namespace
{

namespace fs = std::filesystem;

/// File of the command line, with the words that name it.
struct NamedFile
{
  std::string Name, Path;
};

bool IsSameFile(const std::string& one, const std::string& other)
{
  std::error_code error;
  if (fs::equivalent(one, other, error))
  {
    return true;
  }
  const auto resolve = [](const std::string& path)
  {
    std::error_code isUnresolved;
    const fs::path end = FindFinalPath(path);
    const fs::path resolved = fs::weakly_canonical(end, isUnresolved);
    return isUnresolved ? end.lexically_normal() : resolved;
  };
  return resolve(one) == resolve(other);
}

std::vector<NamedFile> ListInputs(const Arguments& arguments)
{
  std::vector<NamedFile> inputs;
  for (const std::string& path : arguments.SurfaceFiles)
  {
    inputs.push_back({ "input", path });
  }
  if (inputs.empty())
  {
    inputs.push_back({ "input", arguments.Input });
  }
  if (arguments.SurfaceFiles.empty() && !IsBlockFile(arguments.Input) && AreSlices(arguments.Input))
  {
    ClassifyErrors(ErrorCode::UnreadableInput,
      [&]
      {
        for (const std::string& slice : ListSlices(arguments.Input))
        {
          inputs.push_back({ "input", slice });
        }
      });
  }
  inputs.push_back({ "--label-names", arguments.Mesher.LabelNames });
  return inputs;
}

} // namespace

void CheckFiles(const Arguments& arguments)
{
  std::vector<NamedFile> earlier = ListInputs(arguments);
  for (const NamedFile& output : { NamedFile{ "output", arguments.Output },
         { "--fragments", arguments.Fragments }, { "--geometry", arguments.Geometry },
         { "--surfaces", arguments.Surfaces }, { "--report", arguments.Report } })
  {
    if (output.Path.empty() || IsWrittenInPlace(output.Path))
    {
      continue;
    }
    const auto same = std::find_if(earlier.begin(), earlier.end(),
      [&output](const NamedFile& file)
      { return !file.Path.empty() && IsSameFile(file.Path, output.Path); });
    if (same != earlier.end())
    {
      throw InputError(ErrorCode::WrongArguments,
        "The " + output.Name + " " + output.Path + " is the same file as the " + same->Name + " " +
          same->Path + ": every output needs its own name.");
    }
    earlier.push_back(output);
  }
}

} // namespace vfm
