#include "FindArrays.h"

#include "Ranks/Agreement.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

namespace vfm
{
namespace
{

std::vector<ArrayInfo> FindOwnArrays(const std::vector<vtkDataSetAttributes*>& attributes)
{
  std::vector<ArrayInfo> list;
  for (vtkDataSetAttributes* own : attributes)
  {
    for (int i = 0; i < own->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = own->GetArray(i);
      if (array && array->GetName() && array->GetNumberOfTuples() > 0)
      {
        const double* range = array->GetRange(0);
        const bool holdsIds = array == own->GetGlobalIds() || array == own->GetPedigreeIds();
        AddArray(list,
          { array->GetName(), array->GetDataType(), array->GetNumberOfComponents(), range[0],
            range[1], 1, true, holdsIds });
      }
    }
  }
  return list;
}

} // namespace

std::vector<ArrayInfo> FindArrays(
  const std::vector<vtkDataSetAttributes*>& attributes, Ranks& ranks)
{
  std::vector<ArrayInfo> mine;
  WorkTogether(ranks, [&] { mine = FindOwnArrays(attributes); });
  return UniteArrays(mine, ranks);
}

} // namespace vfm
