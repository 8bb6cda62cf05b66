#include "HostImages.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

namespace vfm
{
namespace
{

/// VTK asks for a pointer that is not const; nothing writes to the input of a filter.
template <class Array>
vtkSmartPointer<vtkDataArray> Wrap(const HostArray& from, Index cells)
{
  using Value = typename Array::ValueType;
  vtkNew<Array> array;
  array->SetName(from.Name.c_str());
  array->SetNumberOfComponents(from.Components);
  const int keep = 1; // VTK does not free the values
  array->SetArray(
    const_cast<Value*>(static_cast<const Value*>(from.Values)), cells * from.Components, keep);
  return array;
}

vtkSmartPointer<vtkDataArray> MakeArray(const HostArray& from, Index cells)
{
  switch (from.Type)
  {
    case HostType::Float:
      return Wrap<vtkFloatArray>(from, cells);
    case HostType::Int:
      return Wrap<vtkIntArray>(from, cells);
    case HostType::UnsignedChar:
      return Wrap<vtkUnsignedCharArray>(from, cells);
    default:
      return Wrap<vtkDoubleArray>(from, cells);
  }
}

vtkSmartPointer<vtkImageData> MakeCheckedImage(const HostGrid& grid, const HostBox& box)
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

} // namespace

vtkSmartPointer<vtkImageData> MakeImage(const HostGrid& grid, const HostBox& box)
{
  CheckHostBox(grid, box);
  return MakeCheckedImage(grid, box);
}

vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(
  const HostGrid& grid, unsigned int first, unsigned int total)
{
  CheckHostGrid(grid);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(total);
  for (const HostBox& box : grid.Boxes)
  {
    blocks->SetBlock(first++, MakeCheckedImage(grid, box));
  }
  return blocks;
}

} // namespace vfm
