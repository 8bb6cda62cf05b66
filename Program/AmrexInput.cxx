#include "AmrexInput.h"

#include "AmrexPlotfile.h"

#include "vtkAMReXGridReader.h"

#include <filesystem>
#include <limits>
#include <set>

namespace vfm
{

bool IsAmrexFolder(const std::string& path)
{
  std::error_code error; // of a path that cannot be looked at: no
  return std::filesystem::is_regular_file(path + "/Header", error);
}

void CheckAmrexFolder(const Arguments& arguments, Ranks& ranks)
{
  if (!IsAmrexFolder(arguments.Input))
  {
    return;
  }
  const AmrexPlotfile file(arguments.Input);
  for (int block = ranks.Rank(); block < file.NumberOfBlocks(); block += ranks.Count())
  {
    file.CheckBlock(block);
  }
}

vtkSmartPointer<vtkAlgorithm> MakeAmrexReader(const Arguments& arguments)
{
  auto reader = vtkSmartPointer<vtkAMReXGridReader>::New();
  reader->SetFileName(arguments.Input.c_str());
  reader->SetMaxLevel(std::numeric_limits<int>::max());
  return reader;
}

void ChooseAmrexArrays(vtkAlgorithm* algorithm, const Arguments& arguments)
{
  vtkAMReXGridReader* reader = vtkAMReXGridReader::SafeDownCast(algorithm);
  std::set<std::string> named(arguments.Fractions.begin(), arguments.Fractions.end());
  std::vector<std::string> there;
  for (int i = 0; reader && i < reader->GetNumberOfCellArrays(); ++i)
  {
    there.emplace_back(reader->GetCellArrayName(i));
  }
  const std::vector<std::string> others = ListOtherArrays(arguments, there);
  named.insert(others.begin(), others.end());
  named.insert(arguments.Labels);
  std::size_t found = named.count("");
  for (const std::string& name : there)
  {
    found += named.count(name);
  }
  // Of one that is not there the mesher's message lists those that are.
  const bool takesAll =
    (arguments.Fractions.empty() && arguments.Labels.empty()) || found < named.size();
  for (const std::string& name : there)
  {
    reader->SetCellArrayStatus(name.c_str(), takesAll || named.count(name) > 0);
  }
}

} // namespace vfm
