#include "FileBlocks.h"

#include "Base/ParseText.h"
#include "Blocks/BlockFile.h"
#include "InputTrust.h"
#include "Materials/ChooseMaterials.h"

#include <algorithm>

namespace vfm
{
namespace
{

void CheckNames(const BlockFile& file, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (!file.Has(name))
    {
      throw InputError(
        "it has no array '" + name + "'. Its arrays: '" + JoinTexts(file.Names(), "', '") + "'.");
    }
  }
}

} // namespace

FileBlocks ReadFileBlocks(const std::string& path, int step,
  const std::optional<std::vector<std::string>>& names, bool isTrusted)
{
  const InputTrust trust(isTrusted);
  Ranks alone;
  const std::unique_ptr<BlockFile> file = OpenBlockFile(path, alone);
  const std::vector<double>& times = file->Times();
  const int steps = std::max(static_cast<int>(times.size()), 1);
  const int index = step < 0 ? steps + step : step;
  if (index < 0 || index >= steps)
  {
    throw InputError("there is no step " + std::to_string(step) + ": it has " +
      std::to_string(steps) + ", counted from 0.");
  }
  FileBlocks read{ path, times, times.empty() ? std::nullopt : std::optional(times[index]),
    names.value_or(file->Names()), {}, "", {} };
  CheckNames(*file, read.Names);
  read.Blocks = file->Read(index, read.Names, alone);
  MaterialChoice choice = ChooseMaterials(ListArrays(ListsOf(read.Blocks)), {});
  read.Fractions = std::move(choice.Fractions);
  read.Labels = std::move(choice.Labels);
  return read;
}

} // namespace vfm
