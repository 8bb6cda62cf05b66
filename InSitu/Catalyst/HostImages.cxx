#include "HostImages.h"

#include "HiddenCells.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <cstring>

namespace vfm
{
namespace
{

/// Makes an array of the simulation's memory. VTK requires a pointer that is not const, but nothing
/// writes to the input of a filter.
vtkSmartPointer<vtkDataArray> MakeArray(const HostArray& from, Index cells)
{
  auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(static_cast<int>(from.Type)));
  array->SetName(from.Name.c_str());
  array->SetNumberOfComponents(from.Components);
  const int keep = 1; // VTK must not free the values
  array->SetVoidArray(const_cast<void*>(from.Values), cells * from.Components, keep);
  return array;
}

vtkSmartPointer<vtkImageData> MakeImage(const HostGrid& grid, const HostBox& box)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(grid.Origin.data());
  int extent[6];
  for (int a = 0; a < 3; ++a)
  {
    extent[2 * a] = static_cast<int>(box.Cells.Lower[a]);
    extent[2 * a + 1] = static_cast<int>(box.Cells.Upper[a]);
  }
  image->SetSpacing(SpacingOf(grid, box.Level).data());
  image->SetExtent(extent);
  for (const HostArray& array : box.Arrays)
  {
    image->GetCellData()->AddArray(MakeArray(array, box.Cells.NumberOfCells()));
  }
  return image;
}

static_assert(DuplicateCell == vtkDataSetAttributes::DUPLICATECELL &&
    HiddenCell == vtkDataSetAttributes::HIDDENCELL,
  "the bits have the values of VTK");

void AddGhostTypes(const std::vector<unsigned char>& types, vtkDataObject* image)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(GhostTypeName);
  array->SetNumberOfValues(static_cast<vtkIdType>(types.size()));
  std::memcpy(array->GetPointer(0), types.data(), types.size());
  image->GetAttributes(vtkDataObject::CELL)->AddArray(array);
}

} // namespace

vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(
  const HostGrid& grid, unsigned int first, unsigned int total)
{
  CheckHostGrid(grid);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(total);
  for (const HostBox& box : grid.Boxes)
  {
    blocks->SetBlock(first++, MakeImage(grid, box));
  }
  return blocks;
}

vtkSmartPointer<vtkMultiBlockDataSet> MakeAllBlocks(const HostGrid& grid, Ranks& ranks)
{
  CheckHostGrid(grid);
  const HostPlaces places = GatherHostPlaces(grid, ranks);
  auto block = static_cast<unsigned int>(places.First);
  auto blocks = MakeBlocks(grid, block, static_cast<unsigned int>(places.All.size()));
  for (const HostBox& box : grid.Boxes)
  {
    const std::vector<unsigned char> types = HideCovered(box, places);
    if (!types.empty())
    {
      AddGhostTypes(types, blocks->GetBlock(block));
    }
    ++block;
  }
  return blocks;
}

} // namespace vfm
