#include "JoinComponents.h"

#include "InputGrids.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace vfm
{
namespace
{

vtkSmartPointer<vtkDataArray> Join(
  vtkCellData* data, const std::string& name, const std::vector<std::string>& components)
{
  vtkDataArray* first = data->GetArray(components[0].c_str());
  vtkSmartPointer<vtkDataArray> joined;
  joined.TakeReference(first->NewInstance());
  joined->SetName(name.c_str());
  joined->SetNumberOfComponents(static_cast<int>(components.size()));
  joined->SetNumberOfTuples(first->GetNumberOfTuples());
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    joined->CopyComponent(static_cast<int>(c), data->GetArray(components[c].c_str()), 0);
  }
  return joined;
}

} // namespace

std::vector<std::vector<std::string>> ListComponentNames(const std::string& vector)
{
  if (vector.empty())
  {
    return {};
  }
  return { { "X " + vector, "Y " + vector, "Z " + vector },
    { "x_" + vector, "y_" + vector, "z_" + vector } };
}

void JoinComponents(vtkDataObject* data, const std::string& vector)
{
  for (vtkDataSet* grid : GetGrids(data))
  {
    vtkCellData* cells = grid->GetCellData();
    const auto isThere = [cells](const std::string& name)
    {
      vtkDataArray* array = cells->GetArray(name.c_str());
      return array && array->GetNumberOfComponents() == 1;
    };
    for (const std::vector<std::string>& components : ListComponentNames(vector))
    {
      if (!cells->HasArray(vector.c_str()) &&
        std::all_of(components.begin(), components.end(), isThere))
      {
        cells->AddArray(Join(cells, vector, components));
      }
    }
  }
}

} // namespace vfm
