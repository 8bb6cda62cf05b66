#include "SpyPlotInput.h"

#include "Base/Runtime.h"
#include "FileSuffix.h"

#include "vtkAlgorithm.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>

#ifdef VFM_HAS_SPYPLOT
#include "vtkSpyPlotReader.h"

#include <cstring>
#endif

namespace vfm
{
namespace
{

bool IsWanted(const std::string& name, const Arguments& arguments)
{
  const auto lists = [&name](const std::vector<std::string>& names)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  const bool isFound =
    arguments.Fractions.empty() && arguments.Labels.empty() && IsSpyPlotFraction(name);
  return arguments.Task == Command::List || isFound || lists(arguments.Fractions) ||
    lists(ListOtherArrays(arguments, { name })) || name == arguments.Labels;
}

/// Whether a text has characters that none is made of, which a terminal would obey.
bool HasControls(const std::string& text)
{
  return std::any_of(
    text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; });
}

/// The binary files that a case file names; a binary file is its own only one.
std::vector<std::string> FindFiles(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string line;
  std::getline(stream, line);
  if (line.compare(0, 7, "spydata") == 0)
  {
    return { path };
  }
  if (line.compare(0, 7, "spycase") != 0)
  {
    throw InputError("it is no SpyPlot file: it begins neither with spycase nor with spydata.");
  }
  std::vector<std::string> files;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  while (std::getline(stream, line))
  {
    line.resize(line.size() - (!line.empty() && line.back() == '\r'));
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (!line.empty() && begin == std::string::npos)
    {
      throw InputError("a line of it holds blanks only, which ParaView's reader cannot read.");
    }
    if (!line.empty() && line[begin] != '#')
    {
      line = line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
      if (HasControls(line))
      {
        throw InputError("it is cut or damaged: a line of it is no name of a file.");
      }
      files.push_back((folder / line).string());
    }
  }
  if (files.empty())
  {
    throw InputError("it names no files.");
  }
  return files;
}

} // namespace

bool IsSpyPlotFraction(const std::string& name)
{
  // "Material volume fraction - 1", of newer files "Volume Fraction - 1"; these ParaView's reader takes for fractions.
  static const std::regex pattern(".*[vV]olume [fF]raction - [0-9]+");
  return std::regex_match(name, pattern);
}

std::vector<SpyPlotFile> OpenSpyPlotFiles(const Arguments& arguments, int rank, int ranks)
{
  std::vector<SpyPlotFile> mine;
  if (!HasSuffix(arguments.Input, SpyPlotSuffix))
  {
    return mine;
  }
  const std::vector<std::string> files = FindFiles(arguments.Input);
  const SpyPlotFile first(files[0]);
  for (std::size_t f = rank; f < files.size(); f += ranks)
  {
    mine.emplace_back(files[f]);
    if (mine.back().Times() != first.Times())
    {
      throw InputError(
        "its files hold different times, see " + files[0] + " and " + files[f] + ".");
    }
    if (mine.back().IsFlat() != first.IsFlat())
    {
      throw InputError("of its files some have one block and others several, see " + files[0] +
        " and " + files[f] + ". ParaView's reader takes either a flat mesh or one of blocks.");
    }
    if (mine.back().Names() != first.Names())
    {
      throw InputError(
        "its files hold different arrays, see " + files[0] + " and " + files[f] + ".");
    }
  }
  return mine;
}

void CheckSpyPlotArrays(
  const std::vector<SpyPlotFile>& files, double time, const Arguments& arguments)
{
  for (const SpyPlotFile& file : files)
  {
    file.CheckArrays(
      time, [&arguments](const std::string& name) { return IsWanted(name, arguments); });
  }
}

#ifdef VFM_HAS_SPYPLOT

bool HasSpyPlotReader()
{
  return true;
}

vtkSmartPointer<vtkAlgorithm> MakeSpyPlotReader(const Arguments& arguments)
{
  auto reader = vtkSmartPointer<vtkSpyPlotReader>::New();
  // It looks in the root folder for the files of a case without a folder.
  reader->SetFileName(std::filesystem::absolute(arguments.Input).c_str());
  reader->SetMergeXYZComponents(0); // arrays keep the names that the user reads in the file
  return reader;
}

void ChooseSpyPlotArrays(vtkAlgorithm* algorithm, const Arguments& arguments, Ranks& ranks)
{
  vtkSpyPlotReader* reader = vtkSpyPlotReader::SafeDownCast(algorithm);
  Bytes names; // each ends with 0; only the first rank's reader knows them
  for (int i = 0; reader && i < reader->GetNumberOfCellArrays(); ++i)
  {
    const std::string name = reader->GetCellArrayName(i);
    names.insert(names.end(), name.c_str(), name.c_str() + name.size() + 1);
  }
  const Bytes first = ranks.Gather(names)[0];
  for (std::size_t i = 0; i < first.size(); i += std::strlen(&first[i]) + 1)
  {
    reader->SetCellArrayStatus(&first[i], IsWanted(&first[i], arguments) ? 1 : 0);
  }
  if (reader)
  {
    // 256 steps would show in the surfaces. ParaView 5.11 tells this to the readers of those files
    // only that it knows when it is set, so not before.
    reader->SetDownConvertVolumeFraction(0);
  }
}

#else

bool HasSpyPlotReader()
{
  return false;
}

vtkSmartPointer<vtkAlgorithm> MakeSpyPlotReader(const Arguments&)
{
  return nullptr;
}

void ChooseSpyPlotArrays(vtkAlgorithm*, const Arguments&, Ranks&) {}

#endif

} // namespace vfm
