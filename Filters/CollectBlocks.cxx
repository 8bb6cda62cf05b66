#include "CollectBlocks.h"

#include "ArrayMemory.h"
#include "Base/Runtime.h"
#include "NodeCoordinates.h"
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

/// Of the nodes along the own axes of the image; where points are cells these are the middles between them, and half a spacing
/// beyond.
std::array<std::vector<double>, 3> ImageCoordinates(
  vtkImageData* image, const InputReading& reading)
{
  const bool arePoints = reading.Association == vtkDataObject::POINT;
  const Vector3 origin = reading.Frame.OriginOf(image);
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    const int* extent = image->GetExtent() + 2 * a;
    const double spacing = image->GetSpacing()[a];
    const double start = arePoints ? origin[a] - 0.5 * spacing : origin[a];
    for (int i = extent[0]; i <= extent[1] + arePoints; ++i)
    {
      coordinates[a].push_back(start + i * spacing);
    }
  }
  return coordinates;
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

void CheckCoordinates(const InputBlock& block)
{
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = block.Coordinates[a];
    if (x.size() < 2)
    {
      throw InputError(block.Name + " is flat: it has no cells along " + AxisNames[a] +
        ". Volume fractions on a 3D grid of cells are needed.");
    }
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      if (!std::isfinite(x[i]) || (i > 0 && !(x[i] > x[i - 1])))
      {
        std::ostringstream text;
        text << block.Name << ": the " << AxisNames[a]
             << " coordinates do not increase or are not finite at node " << i << " (" << x[i]
             << ").";
        throw InputError(text.str());
      }
    }
  }
}

/// What is said of cells; where points are cells in the bits of cells. Null: nothing.
vtkSmartPointer<vtkUnsignedCharArray> FindCellTypes(const InputBlock& block)
{
  const auto types = InMemory(FindGhostTypes(block.Data, block.Association));
  if (!types || block.Association != vtkDataObject::POINT)
  {
    return types;
  }
  auto ofCells = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ofCells->SetNumberOfValues(types->GetNumberOfValues());
  for (vtkIdType p = 0; p < types->GetNumberOfValues(); ++p)
  {
    const int type = types->GetValue(p);
    const bool isGhost = (type & vtkDataSetAttributes::DUPLICATEPOINT) != 0;
    const bool isHidden = (type & vtkDataSetAttributes::HIDDENPOINT) != 0;
    ofCells->SetValue(p,
      static_cast<unsigned char>((isGhost ? vtkDataSetAttributes::DUPLICATECELL : 0) |
        (isHidden ? vtkDataSetAttributes::HIDDENCELL : 0)));
  }
  return ofCells;
}

/// Sets Kept to the box of the cells that are no ghosts; false when there is none.
bool DropGhosts(InputBlock& block)
{
  for (int a = 0; a < 3; ++a)
  {
    block.Dimensions[a] = static_cast<Index>(block.Coordinates[a].size()) - 1;
  }
  block.Kept.Upper = block.Dimensions;
  block.GhostTypes = FindCellTypes(block);
  if (!block.GhostTypes)
  {
    return true;
  }
  const unsigned char* types = block.GhostTypes->GetPointer(0);
  IndexBox box{ block.Dimensions, { { 0, 0, 0 } } };
  Index kept = 0, id = 0;
  ForCells({ { { 0, 0, 0 } }, block.Dimensions },
    [&](const Index3& cell)
    {
      if (types[id++] & vtkDataSetAttributes::DUPLICATECELL)
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

/// The data when it gives its cells by their corners, else null.
vtkPointSet* FindCorners(vtkDataObject* data)
{
  if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return grid;
  }
  return vtkStructuredGrid::SafeDownCast(data);
}

[[noreturn]] void RefusePoints(const InputPart& part)
{
  throw InputError(part.Name + " is a " + part.Data->GetClassName() +
    ", and point data are chosen. A point is the centre of a cell in images (image data, uniform "
    "grids) alone; of other grids cell data are needed. ParaView's filter Resample To Image makes "
    "an image of them; Point Data to Cell Data averages, which serves volume fractions, not "
    "labels.");
}

/// Appends the blocks of a part unless it has no cells but ghosts.
void AddBlocks(const InputPart& part, const InputReading& reading, std::vector<InputBlock>& blocks)
{
  vtkImageData* image = vtkImageData::SafeDownCast(part.Data);
  vtkPointSet* corners = FindCorners(part.Data);
  vtkRectilinearGrid* rectilinear = vtkRectilinearGrid::SafeDownCast(part.Data);
  if (reading.Association == vtkDataObject::POINT && (corners || rectilinear) && part.HasPoints())
  {
    RefusePoints(part);
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
  block.Data = vtkDataSet::SafeDownCast(part.Data);
  block.Number = part.Number;
  block.Name = part.Name;
  block.Association = reading.Association;
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
  CheckCoordinates(block);
  if (DropGhosts(block))
  {
    blocks.push_back(std::move(block));
  }
}

} // namespace

std::string NameBlock(int number, int rank, bool isAlone)
{
  const std::string name = number < 0 ? "The input" : "Block " + std::to_string(number);
  return isAlone ? name : name + " of rank " + std::to_string(rank);
}

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
    // flat when there are fewer cells than ranks
    parts.push_back({ input, -1, NameBlock(-1, rank, isAlone), !isAlone });
  }
  return parts;
}

std::vector<InputBlock> CollectBlocks(
  const std::vector<InputPart>& parts, const InputReading& reading)
{
  std::vector<InputBlock> blocks;
  for (const InputPart& part : parts)
  {
    AddBlocks(part, reading, blocks);
  }
  return blocks;
}

} // namespace vfm
