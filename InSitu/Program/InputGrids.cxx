#include "InputGrids.h"

#include "ParseText.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
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

void Merge(std::vector<ArrayInfo>& list, const ArrayInfo& info)
{
  const auto found = std::find_if(
    list.begin(), list.end(), [&info](const ArrayInfo& other) { return other.Name == info.Name; });
  if (found == list.end())
  {
    list.push_back(info);
    return;
  }
  found->Least = std::min(found->Least, info.Least);
  found->Most = std::max(found->Most, info.Most);
}

std::vector<ArrayInfo> FindOwnArrays(vtkDataObject* data, ArrayPlace place)
{
  std::vector<ArrayInfo> list;
  for (vtkDataSet* grid : GetGrids(data))
  {
    vtkDataSetAttributes* attributes = GetAttributes(grid, place);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && array->GetName() && array->GetName() != std::string("vtkGhostType"))
      {
        const double* range = array->GetRange(0);
        Merge(list,
          { array->GetName(), array->GetDataType(), array->GetNumberOfComponents(), range[0],
            range[1] });
      }
    }
  }
  return list;
}

/// Numbers and name of an array as one message.
struct Packed
{
  int Type, Components;
  double Least, Most;
  std::size_t NameLength;
};

Bytes Pack(const std::vector<ArrayInfo>& list)
{
  Bytes bytes;
  for (const ArrayInfo& info : list)
  {
    const Bytes numbers = ToBytes(std::vector<Packed>{
      { info.Type, info.Components, info.Least, info.Most, info.Name.size() } });
    bytes.insert(bytes.end(), numbers.begin(), numbers.end());
    bytes.insert(bytes.end(), info.Name.begin(), info.Name.end());
  }
  return bytes;
}

void Unpack(const Bytes& bytes, std::vector<ArrayInfo>& list)
{
  for (auto at = bytes.begin(); at != bytes.end();)
  {
    const Packed numbers = FromBytes<Packed>(Bytes(at, at + sizeof(Packed)))[0];
    at += sizeof(Packed);
    Merge(list,
      { std::string(at, at + numbers.NameLength), numbers.Type, numbers.Components, numbers.Least,
        numbers.Most });
    at += numbers.NameLength;
  }
}

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
  std::vector<ArrayInfo> list;
  for (const Bytes& bytes : ranks.Gather(Pack(FindOwnArrays(data, place))))
  {
    Unpack(bytes, list);
  }
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
