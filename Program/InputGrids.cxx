#include "InputGrids.h"

#include "Base/ParseText.h"
#include "FindArrays.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdio>

namespace vfm
{
namespace
{

std::string Describe(const ArrayInfo& info)
{
  char values[80];
  std::snprintf(values, sizeof(values), "%g to %g", info.Least, info.Most);
  return info.Name + " (" + vtkImageScalarTypeNameMacro(info.Type) + ", " +
    (info.Components == 1 ? values : std::to_string(info.Components) + " components") + ")";
}

std::string ListArrays(const std::vector<ArrayInfo>& arrays)
{
  std::vector<std::string> texts;
  for (const ArrayInfo& info : arrays)
  {
    texts.push_back(Describe(info));
  }
  return JoinTexts(texts);
}

} // namespace

std::vector<vtkDataSet*> GetGrids(vtkDataObject* data)
{
  std::vector<vtkDataSet*> grids;
  const auto add = [&grids](vtkDataObject* object)
  {
    vtkDataSet* grid = vtkDataSet::SafeDownCast(object);
    if (grid && grid->GetNumberOfCells() > 0)
    {
      grids.push_back(grid);
    }
  };
  if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      add(it->GetCurrentDataObject());
    }
  }
  else
  {
    add(data);
  }
  return grids;
}

vtkDataSetAttributes* GetAttributes(vtkDataSet* grid, ArrayPlace place)
{
  if (place == ArrayPlace::Points)
  {
    return grid->GetPointData();
  }
  return grid->GetCellData();
}

bool AreImages(vtkDataObject* data, Ranks& ranks)
{
  const std::vector<vtkDataSet*> grids = GetGrids(data);
  return !ranks.Any(std::any_of(grids.begin(), grids.end(),
    [](vtkDataSet* grid) { return !vtkImageData::SafeDownCast(grid); }));
}

std::vector<ArrayInfo> FindArrays(vtkDataObject* data, ArrayPlace place, Ranks& ranks)
{
  std::vector<vtkDataSetAttributes*> attributes;
  for (vtkDataSet* grid : GetGrids(data))
  {
    attributes.push_back(GetAttributes(grid, place));
  }
  std::vector<ArrayInfo> list = FindArrays(attributes, ranks);
  list.erase(std::remove_if(list.begin(), list.end(),
               [](const ArrayInfo& array) { return array.Name == "vtkGhostType"; }),
    list.end());
  return list;
}

std::string DescribeArrays(vtkDataObject* data, Ranks& ranks)
{
  const std::string points = ListArrays(FindArrays(data, ArrayPlace::Points, ranks));
  const std::string cells = ListArrays(FindArrays(data, ArrayPlace::Cells, ranks));
  const char* which = AreImages(data, ranks) ? "" : ", which cannot be meshed";
  return "Its cell arrays: " + (cells.empty() ? "none" : cells) + "." +
    (points.empty() ? "" : std::string(" Its point arrays") + which + ": " + points + ".");
}

} // namespace vfm
