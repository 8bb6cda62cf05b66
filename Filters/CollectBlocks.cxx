#include "CollectBlocks.h"

#include "ArrayMemory.h"
#include "Base/Runtime.h"
#include "BlockArraysOfData.h"
#include "FindImageFrame.h"
#include "Input/NodeCoordinates.h"
#include "InputAssociation.h"
#include "Ranks/Agreement.h"
#include "RecogniseGrid.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <sstream>

namespace vfm
{
namespace
{

/// Returns the nodes along the axes of an image. If points are used as cells, nodes are the
/// midpoints between points, and half a spacing beyond the outer points.
std::array<std::vector<double>, 3> ImageCoordinates(
  vtkImageData* image, const InputReading& reading)
{
  Vector3 origin, spacing;
  image->GetOrigin(origin.data());
  image->GetSpacing(spacing.data());
  const int* extent = image->GetExtent();
  IndexBox cells;
  for (int a = 0; a < 3; ++a)
  {
    cells.Lower[a] = extent[2 * a];
    cells.Upper[a] = extent[2 * a + 1] + reading.ArePoints;
  }
  return EvenCoordinates(reading.Frame.OriginOf(origin), spacing, cells, reading.ArePoints);
}

std::array<std::vector<double>, 3> RectilinearCoordinates(vtkRectilinearGrid* grid)
{
  vtkDataArray* arrays[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    const vtkIdType count = arrays[a] ? arrays[a]->GetNumberOfTuples() : 0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      coordinates[a].push_back(arrays[a]->GetComponent(i, 0));
    }
  }
  return coordinates;
}

bool IsFlat(const InputBlock& block)
{
  return std::any_of(block.Coordinates.begin(), block.Coordinates.end(),
    [](const std::vector<double>& x) { return x.size() < 2; });
}

// ParaView's readers of pictures make images whose cells are flat.
constexpr const char* FlatAdvice =
  "In ParaView, Label Slices Reader reads pictures and slices (.tif, .png) as layers of cells.";

[[noreturn]] void RejectFlat(const InputBlock& block)
{
  int axis = 0;
  while (block.Coordinates[axis].size() >= 2)
  {
    ++axis;
  }
  throw InputError(block.Name + " is flat: it has no cells along " + AxisNames[axis] +
    ". Volume fractions on a 3D grid of cells are needed. " + FlatAdvice);
}

static_assert(CellMark::Ghost == vtkDataSetAttributes::DUPLICATECELL &&
    CellMark::Hidden == vtkDataSetAttributes::HIDDENCELL &&
    CellMark::Ghost == vtkDataSetAttributes::DUPLICATEPOINT,
  "marks must have the values of VTK");

/// Returns the marks of cells, or null. Marks of points are converted to the bits of cells.
std::shared_ptr<const std::vector<unsigned char>> FindMarks(vtkDataSet* data, bool arePoints)
{
  const auto marks =
    MarksOf(FindGhostTypes(data, arePoints ? vtkDataObject::POINT : vtkDataObject::CELL));
  if (marks && arePoints)
  {
    for (unsigned char& mark : *marks)
    {
      const bool isHidden = (mark & vtkDataSetAttributes::HIDDENPOINT) != 0;
      mark = (mark & CellMark::Ghost) | (isHidden ? CellMark::Hidden : 0);
    }
  }
  return marks;
}

/// Sets Kept to the box of the cells that are not ghost cells. Returns false if there are none.
bool DropGhosts(InputBlock& block)
{
  KeepAllCells(block);
  if (!block.Marks)
  {
    return true;
  }
  const unsigned char* marks = block.Marks->data();
  IndexBox box{ block.Dimensions, { { 0, 0, 0 } } };
  Index kept = 0, id = 0;
  ForCells({ { { 0, 0, 0 } }, block.Dimensions },
    [&](const Index3& cell)
    {
      if (marks[id++] & CellMark::Ghost)
      {
        return;
      }
      ++kept;
      for (int a = 0; a < 3; ++a)
      {
        box.Lower[a] = std::min(box.Lower[a], cell[a]);
        box.Upper[a] = std::max(box.Upper[a], cell[a] + 1);
      }
    });
  if (kept > 0 && kept != box.NumberOfCells())
  {
    throw InputError(block.Name +
      " has ghost cells (vtkGhostType) among its own cells. Ghost cells may only "
      "form layers on the sides of a block.");
  }
  block.Kept = box;
  for (int a = 0; a < 3 && kept > 0; ++a)
  {
    std::vector<double>& x = block.Coordinates[a];
    x = std::vector<double>(x.begin() + box.Lower[a], x.begin() + box.Upper[a] + 1);
  }
  return kept > 0;
}

/// Returns the data as a point set if it has explicit cells, else null.
vtkPointSet* FindCorners(vtkDataObject* data)
{
  if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return grid;
  }
  return vtkStructuredGrid::SafeDownCast(data);
}

[[noreturn]] void RejectPoints(const InputPart& part)
{
  throw InputError(part.Name + " is a " + part.Data->GetClassName() +
    ", and point data are chosen. Points are the centres of cells only in images (image data, "
    "uniform grids); other grids need cell data. ParaView's filter Resample To Image makes an "
    "image; Point Data to Cell Data averages, which suits volume fractions, but not labels.");
}

/// Appends the blocks of a part, unless all its cells are ghost cells.
void AddBlocks(const InputPart& part, const InputReading& reading, std::vector<InputBlock>& blocks)
{
  vtkImageData* image = vtkImageData::SafeDownCast(part.Data);
  vtkPointSet* corners = FindCorners(part.Data);
  vtkRectilinearGrid* rectilinear = vtkRectilinearGrid::SafeDownCast(part.Data);
  if (reading.ArePoints && (corners || rectilinear) && part.HasPoints())
  {
    RejectPoints(part);
  }
  if (corners)
  {
    for (InputBlock& box : RecogniseGrid(corners, part.Number, part.Name))
    {
      blocks.push_back(std::move(box));
    }
    return;
  }
  InputBlock block;
  block.Number = part.Number;
  block.Name = part.Name;
  block.ArePoints = reading.ArePoints;
  if (!image && !rectilinear)
  {
    throw InputError(block.Name + " is a " + part.Data->GetClassName() +
      ". Image data, uniform grids, rectilinear grids and hexahedra that form a Cartesian grid can "
      "be meshed; bring other data onto a grid first (ParaView's filter Resample To Image).");
  }
  block.Coordinates =
    image ? ImageCoordinates(image, reading) : RectilinearCoordinates(rectilinear);
  if (!part.HasPoints() || (part.IsPiece && IsFlat(block)))
  {
    return;
  }
  if (image && IsFlat(block))
  {
    RejectFlat(block);
  }
  CheckCoordinates(block);
  vtkDataSet* data = vtkDataSet::SafeDownCast(part.Data);
  block.Arrays = ArraysOf(data, reading.ArePoints ? vtkDataObject::POINT : vtkDataObject::CELL);
  block.Marks = FindMarks(data, reading.ArePoints);
  if (DropGhosts(block))
  {
    blocks.push_back(std::move(block));
  }
}

} // namespace

bool InputPart::HasPoints() const
{
  return this->Data->GetNumberOfElements(vtkDataObject::POINT) > 0;
}

std::vector<InputPart> FindParts(vtkDataObject* input, int rank, bool isAlone)
{
  std::vector<InputPart> parts;
  if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    int number = 0;
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem(), ++number)
    {
      parts.push_back(
        { it->GetCurrentDataObject(), number, NameBlock(number, rank, isAlone), false });
    }
  }
  else if (input)
  {
    // a piece is flat if there are fewer cells than ranks
    parts.push_back({ input, -1, NameBlock(-1, rank, isAlone), !isAlone });
  }
  return parts;
}

std::shared_ptr<std::vector<unsigned char>> MarksOf(vtkDataArray* ghostTypes)
{
  if (!ghostTypes)
  {
    return nullptr;
  }
  const auto types = InMemory(ghostTypes);
  const unsigned char* first = types->GetPointer(0);
  return std::make_shared<std::vector<unsigned char>>(first, first + types->GetNumberOfValues());
}

ArraysToRead ListArrays(
  std::vector<ChosenArray> materials, const StateChoice& state, const MesherOptions& options)
{
  ArraysToRead arrays{ std::move(materials), {} };
  for (const std::string& name : state.Arrays)
  {
    arrays.Others.push_back({ name });
  }
  const std::string refinement = FindRefinementArray(options);
  if (!refinement.empty())
  {
    arrays.Others.push_back({ refinement });
  }
  return arrays;
}

CollectedBlocks CollectAllBlocks(vtkDataObject* data, const ArraysToRead& arrays, Ranks& ranks)
{
  std::vector<InputPart> parts;
  WorkTogether(ranks, [&] { parts = FindParts(data, ranks.Rank(), ranks.Count() == 1); });
  CollectedBlocks collected;
  collected.Reading.ArePoints = FindAssociation(parts, arrays, ranks) == vtkDataObject::POINT;
  collected.Reading.Frame = FindImageFrame(parts, ranks);
  WorkTogether(ranks,
    [&]
    {
      for (const InputPart& part : parts)
      {
        AddBlocks(part, collected.Reading, collected.Blocks);
      }
    });
  if (!ranks.Any(!collected.Blocks.empty()))
  {
    throw InputError("The input has no cells. Volume fractions on a 3D grid of cells are needed. " +
      std::string(FlatAdvice));
  }
  return collected;
}

} // namespace vfm
