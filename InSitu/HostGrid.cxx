#include "HostGrid.h"

#include "Base/Runtime.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

constexpr const char* AxisNames[3] = { "x", "y", "z" };
constexpr Index EndOfInts = std::numeric_limits<int>::max(); // nodes are counted by ints, too

void CheckAxes(const HostGrid& grid)
{
  for (int a = 0; a < 3; ++a)
  {
    std::ostringstream text;
    if (!std::isfinite(grid.Origin[a]))
    {
      text << "The origin of the grid along " << AxisNames[a] << " is not finite.";
    }
    else if (!std::isfinite(grid.Spacing[a]) || !(grid.Spacing[a] > 0))
    {
      text << "The spacing of the grid along " << AxisNames[a] << " is " << grid.Spacing[a]
           << "; it must be finite and greater than 0.";
    }
    else if (grid.Cells[a] < 1 || grid.Cells[a] >= EndOfInts)
    {
      text << "The grid has " << grid.Cells[a] << " cells along " << AxisNames[a]
           << "; it must have at least 1 and fewer than " << EndOfInts << ".";
    }
    if (!text.str().empty())
    {
      throw InputError(text.str());
    }
  }
}

std::string NameBox(const HostBox& box)
{
  const IndexBox& cells = box.Cells;
  std::ostringstream text;
  text << "The box of cells [" << cells.Lower[0] << ", " << cells.Upper[0] << ") x ["
       << cells.Lower[1] << ", " << cells.Upper[1] << ") x [" << cells.Lower[2] << ", "
       << cells.Upper[2] << ")";
  if (box.Level != 0)
  {
    text << " of level " << box.Level;
  }
  return text.str();
}

void CheckArrays(const HostBox& box)
{
  const std::string name = NameBox(box);
  for (std::size_t i = 0; i < box.Arrays.size(); ++i)
  {
    const HostArray& array = box.Arrays[i];
    if (array.Name.empty())
    {
      throw InputError(name + " has an array without a name.");
    }
    if (!array.Values)
    {
      throw InputError(name + ": array '" + array.Name + "' has no values (null pointer).");
    }
    if (array.Components < 1)
    {
      throw InputError(name + ": array '" + array.Name + "' has " +
        std::to_string(array.Components) + " components; it must have at least 1.");
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      if (box.Arrays[j].Name == array.Name)
      {
        throw InputError(name + " has two arrays named '" + array.Name + "'.");
      }
    }
  }
}

void CheckBox(const HostGrid& grid, const HostBox& box)
{
  if (box.Level < 0 || box.Level > MostHostLevels)
  {
    throw InputError(NameBox(box) + " has no level from 0, the coarsest, to " +
      std::to_string(MostHostLevels) + ".");
  }
  for (int a = 0; a < 3; ++a)
  {
    const Index cells = grid.Cells[a] << box.Level;
    if (box.Cells.Size(a) < 1)
    {
      throw InputError(
        NameBox(box) + " is empty along " + AxisNames[a] + ". Leave out boxes without cells.");
    }
    if (box.Cells.Lower[a] < 0 || box.Cells.Upper[a] > cells)
    {
      throw InputError(NameBox(box) + " leaves the grid along " + AxisNames[a] + ", which has " +
        std::to_string(cells) + " cells there.");
    }
    if (box.Cells.Upper[a] >= EndOfInts)
    {
      throw InputError(NameBox(box) + " has cells beyond number " + std::to_string(EndOfInts) +
        " along " + AxisNames[a] + ". Fewer levels are needed.");
    }
  }
  CheckArrays(box);
}

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
  double spacing[3];
  int extent[6];
  for (int a = 0; a < 3; ++a)
  {
    spacing[a] = std::ldexp(grid.Spacing[a], -box.Level);
    extent[2 * a] = static_cast<int>(box.Cells.Lower[a]);
    extent[2 * a + 1] = static_cast<int>(box.Cells.Upper[a]);
  }
  image->SetSpacing(spacing);
  image->SetExtent(extent);
  for (const HostArray& array : box.Arrays)
  {
    image->GetCellData()->AddArray(MakeArray(array, box.Cells.NumberOfCells()));
  }
  return image;
}

} // namespace

void CheckHostGrid(const HostGrid& grid)
{
  CheckAxes(grid);
  for (const HostBox& box : grid.Boxes)
  {
    CheckBox(grid, box);
  }
}

vtkSmartPointer<vtkImageData> MakeImage(const HostGrid& grid, const HostBox& box)
{
  CheckAxes(grid);
  CheckBox(grid, box);
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
