#include "Blocks/BlockFile.h"

#include "FileSuffix.h"

#include <filesystem>
#include <regex>

namespace vfm
{

bool IsPlotfile(const std::string& path)
{
  std::error_code error; // of a path that cannot be looked at: no
  return std::filesystem::is_regular_file(path + "/Header", error);
}

bool IsBlockFile(const std::string& path)
{
  return IsPlotfile(path) || HasSuffix(path, SpyPlotSuffix);
}

std::unique_ptr<BlockFile> OpenBlockFile(const std::string& path, const Ranks& ranks)
{
  return IsPlotfile(path) ? OpenPlotfile(path) : OpenSpyPlot(path, ranks);
}

bool IsSpyPlotFraction(const std::string& name)
{
  // "Material volume fraction - 1", in newer files "Volume Fraction - 1".
  static const std::regex pattern(".*[vV]olume [fF]raction - [0-9]+");
  return std::regex_match(name, pattern);
}

void FinishBlock(InputBlock& block, int number, const Ranks& ranks)
{
  block.Number = number;
  block.Name = NameBlock(number, ranks.Rank(), ranks.Count() == 1);
  CheckCoordinates(block);
  KeepAllCells(block);
}

} // namespace vfm
