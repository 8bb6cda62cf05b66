#include "BlocksInput.h"

#include "Blocks/BlockFile.h"
#include "Input/GuessMaterials.h"
#include "Ranks/WorkTogether.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>

namespace vfm
{
namespace
{

std::vector<std::string> ChooseNames(
  const Arguments& arguments, const std::vector<std::string>& there)
{
  const bool isAny =
    arguments.Task == Command::List || (arguments.Fractions.empty() && arguments.Labels.empty());
  std::vector<std::string> named = ListOtherArrays(arguments, there);
  named.insert(named.end(), arguments.Fractions.begin(), arguments.Fractions.end());
  if (!arguments.Labels.empty())
  {
    named.push_back(arguments.Labels);
  }
  std::vector<std::string> chosen;
  std::copy_if(there.begin(), there.end(), std::back_inserter(chosen),
    [&](const std::string& name)
    {
      return (isAny && IsSpyPlotFraction(name)) ||
        std::find(named.begin(), named.end(), name) != named.end();
    });
  const bool hasFractions = !isAny || std::any_of(chosen.begin(), chosen.end(), IsSpyPlotFraction);
  // Where one is missing the message lists all that are there.
  const bool hasAll = std::all_of(named.begin(), named.end(),
    [&there](const std::string& name)
    { return std::find(there.begin(), there.end(), name) != there.end(); });
  return arguments.Task != Command::List && hasFractions && hasAll ? chosen : there;
}

vtkSmartPointer<vtkDataArray> MakeArray(const std::string& name, const BlockArray& array)
{
  auto made = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array.Type));
  made->SetName(name.c_str());
  made->SetVoidArray(const_cast<void*>(array.Memory), array.Tuples, 1);
  return made;
}

vtkSmartPointer<vtkRectilinearGrid> MakeGrid(const InputBlock& block)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> nodes[3];
  for (int a = 0; a < 3; ++a)
  {
    for (double x : block.Coordinates[a])
    {
      nodes[a]->InsertNextValue(x);
    }
  }
  grid->SetDimensions(
    nodes[0]->GetNumberOfTuples(), nodes[1]->GetNumberOfTuples(), nodes[2]->GetNumberOfTuples());
  grid->SetXCoordinates(nodes[0]);
  grid->SetYCoordinates(nodes[1]);
  grid->SetZCoordinates(nodes[2]);
  for (const std::string& name : block.Arrays->Names())
  {
    grid->GetCellData()->AddArray(MakeArray(name, *block.Arrays->Find(name)));
  }
  return grid;
}

} // namespace

Input ReadBlocks(const Arguments& arguments, Ranks& ranks)
{
  Input input;
  WorkInStage(ranks, ErrorCode::UnreadableInput,
    [&]
    {
      std::unique_ptr<BlockFile> file;
      CheckInput(arguments.Input, [&] { file = OpenBlockFile(arguments.Input, ranks); });
      input.Times = file->Times();
      input.Time = ChooseTime(arguments, input.Times);
      const auto step = std::find(input.Times.begin(), input.Times.end(), *input.Time);
      const std::vector<std::string> names = ChooseNames(arguments, file->Names());
      CheckInput(arguments.Input,
        [&] { input.Blocks = file->Read(step - input.Times.begin(), names, ranks); });
      vtkNew<vtkMultiBlockDataSet> data;
      for (const InputBlock& block : input.Blocks)
      {
        data->SetBlock(data->GetNumberOfBlocks(), MakeGrid(block));
      }
      input.Data = data;
    });
  return input;
}

} // namespace vfm
