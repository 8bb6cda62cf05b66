#include "Blocks/BlockFile.h"

#include "Blocks/ExodusCase.h"
#include "FileSuffix.h"

#include <filesystem>

namespace vfm
{

bool IsPlotfile(const std::string& path)
{
  std::error_code error; // a path without access is not a plotfile
  return std::filesystem::is_regular_file(path + "/Header", error);
}

bool IsBlockFile(const std::string& path)
{
  return IsPlotfile(path) || HasSuffix(path, SpyPlotSuffix) || IsExodusFile(path);
}

std::unique_ptr<BlockFile> OpenBlockFile(const std::string& path, Ranks& ranks)
{
  if (IsExodusFile(path))
  {
    return std::make_unique<ExodusCase>(path, ranks);
  }
  return IsPlotfile(path) ? OpenPlotfile(path) : OpenSpyPlot(path, ranks);
}

} // namespace vfm
