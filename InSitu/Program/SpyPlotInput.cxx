#include "SpyPlotInput.h"

#include "vtkAlgorithm.h"

#include <algorithm>

#ifdef VFM_HAS_SPYPLOT
#include "vtkDataArraySelection.h"
#include "vtkNew.h"
#include "vtkSpyPlotReader.h"
#include "vtkSpyPlotUniReader.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#endif

namespace vfm
{
namespace
{

constexpr const char* FractionPrefix = "Material volume fraction - ";

#ifdef VFM_HAS_SPYPLOT
bool IsWanted(const std::string& name, const Arguments& arguments)
{
  const auto lists = [&name](const std::vector<std::string>& names)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  const bool isFound =
    arguments.Fractions.empty() && arguments.Labels.empty() && IsSpyPlotFraction(name);
  return isFound || lists(arguments.Fractions) || lists(arguments.State) ||
    name == arguments.Labels;
}

/// The binary files that a case file names; a binary file is its own only one.
std::vector<std::string> FindFiles(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string line;
  std::getline(stream, line);
  std::vector<std::string> files;
  if (line.compare(0, 7, "spydata") == 0)
  {
    files.push_back(path);
  }
  else if (line.compare(0, 7, "spycase") == 0)
  {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    while (std::getline(stream, line))
    {
      const std::size_t begin = std::min(line.find_first_not_of(" \t\r"), line.size());
      line = line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
      if (!line.empty() && line[0] != '#')
      {
        files.push_back((folder / line).string());
      }
    }
  }
  return files;
}

/// How many times a binary file holds; 0 when it cannot be read, VTK's messages tell why.
int CountTimes(const std::string& file)
{
  vtkNew<vtkDataArraySelection> selection;
  auto reader = vtkSmartPointer<vtkSpyPlotUniReader>::New();
  reader->SetCellArraySelection(selection);
  reader->SetFileName(file.c_str());
  if (!reader->ReadInformation())
  {
    reader->Register(nullptr); // lives on: its destructor trips over what it has read in part
    return 0;
  }
  return reader->GetTimeStepRange()[1] + 1;
}
#endif

} // namespace

bool IsSpyPlotFraction(const std::string& name)
{
  return name.compare(0, std::string(FractionPrefix).size(), FractionPrefix) == 0;
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

std::string FindSpyPlotProblem(vtkAlgorithm* algorithm, const Arguments& arguments)
{
  if (!vtkSpyPlotReader::SafeDownCast(algorithm))
  {
    return "";
  }
  const std::vector<std::string> files = FindFiles(arguments.Input);
  int first = 0; // number of times in the first file
  for (const std::string& file : files)
  {
    const int times = CountTimes(file);
    first = first ? first : times;
    if (times == 0)
    {
      return "the file " + file + " that it names is missing or damaged.";
    }
    if (times != first)
    {
      return "its files hold different times, " + file + " " + std::to_string(times) + " and " +
        files[0] + " " + std::to_string(first) + ".";
    }
  }
  return files.empty() ? "it names no files." : "";
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

std::string FindSpyPlotProblem(vtkAlgorithm*, const Arguments&)
{
  return "";
}

void ChooseSpyPlotArrays(vtkAlgorithm*, const Arguments&, Ranks&) {}

#endif

} // namespace vfm
