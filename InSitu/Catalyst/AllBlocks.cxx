#include "AllBlocks.h"

#include "HiddenCells.h"
#include "HostImages.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <cstring>

namespace vfm
{
namespace
{

static_assert(DuplicateCell == vtkDataSetAttributes::DUPLICATECELL &&
    HiddenCell == vtkDataSetAttributes::HIDDENCELL,
  "the bits are VTK's");

void AddGhostTypes(const std::vector<unsigned char>& types, vtkDataObject* image)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(GhostTypeName);
  array->SetNumberOfValues(static_cast<vtkIdType>(types.size()));
  std::memcpy(array->GetPointer(0), types.data(), types.size());
  image->GetAttributes(vtkDataObject::CELL)->AddArray(array);
}

} // namespace

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
