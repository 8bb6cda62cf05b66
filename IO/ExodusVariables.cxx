#include "ExodusVariables.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace vfm
{
namespace
{

constexpr vtkIdType MostNumbers = 100;
constexpr const char* TableNames[] = { "SurfaceParts", "EdgeFacets" }; // no numbers of the mesh
constexpr const char* IdNames[] = { "GlobalPointIds", "GlobalCellIds", "vtkGhostType" };

template <std::size_t Count>
bool IsOneOf(const char* name, const char* const (&names)[Count])
{
  return std::any_of(std::begin(names), std::end(names),
    [name](const char* other) { return std::strcmp(name, other) == 0; });
}

bool IsVariable(vtkDataSetAttributes* data, vtkDataArray* array)
{
  const char* name = array ? array->GetName() : nullptr;
  return name && array != data->GetGlobalIds() && !IsOneOf(name, IdNames);
}

/// place: from 0.
std::string Ending(vtkIdType place, vtkIdType count, bool hasAxes)
{
  if (count == 1)
  {
    return "";
  }
  if (hasAxes && count <= 3)
  {
    return std::string("_") + "XYZ"[place];
  }
  const std::string number = std::to_string(place + 1);
  return "_" + std::string(std::to_string(count).size() - number.size(), '0') + number;
}

} // namespace

std::vector<ExodusVariable> ListVariables(vtkDataSetAttributes* data)
{
  std::vector<ExodusVariable> variables;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    const int count = array ? array->GetNumberOfComponents() : 0;
    for (int c = 0; IsVariable(data, array) && c < count; ++c)
    {
      variables.push_back({ array->GetName() + Ending(c, count, true), array, c });
    }
  }
  return variables;
}

std::vector<ExodusNumber> ListNumbers(vtkFieldData* field)
{
  std::vector<ExodusNumber> numbers;
  for (int a = 0; a < field->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = field->GetArray(a);
    const bool isNumber = array && array->GetName() && !IsOneOf(array->GetName(), TableNames);
    const vtkIdType count = isNumber ? array->GetNumberOfValues() : 0;
    for (vtkIdType i = 0; count <= MostNumbers && i < count; ++i)
    {
      const int components = array->GetNumberOfComponents();
      numbers.push_back({ array->GetName() + Ending(i, count, false),
        array->GetComponent(i / components, static_cast<int>(i % components)) });
    }
  }
  return numbers;
}

} // namespace vfm
