#include "CollectBlocks.h"

#include "Base/Runtime.h"
#include "NodeCoordinates.h"
#include "RecogniseGrid.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <sstream>

namespace vfm
{
namespace
{

std::array<std::vector<double>, 3> ImageCoordinates(vtkImageData* image, const std::string& name)
{
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw InputError(name +
      " is an image with a rotated direction matrix. Set the direction matrix to the "
      "identity and rotate the mesh instead (ParaView's filter Transform).");
  }
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    const int* extent = image->GetExtent() + 2 * a;
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      coordinates[a].push_back(image->GetOrigin()[a] + i * image->GetSpacing()[a]);
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

/// Sets Kept to the box of the cells that are no ghosts; false when there is none.
bool DropGhosts(InputBlock& block)
{
  for (int a = 0; a < 3; ++a)
  {
    block.Dimensions[a] = static_cast<Index>(block.Coordinates[a].size()) - 1;
  }
  block.Kept.Upper = block.Dimensions;
  block.GhostTypes = block.Data->GetCellGhostArray();
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

/// Appends the block unless it has no cells but ghosts.
void AddBlock(
  vtkDataObject* data, int number, int rank, bool isAlone, std::vector<InputBlock>& blocks)
{
  if (vtkPointSet* corners = FindCorners(data))
  {
    for (InputBlock& box : RecogniseGrid(corners, number, NameBlock(number, rank, isAlone)))
    {
      blocks.push_back(std::move(box));
    }
    return;
  }
  InputBlock block;
  block.Data = vtkDataSet::SafeDownCast(data);
  block.Number = number;
  block.Name = NameBlock(number, rank, isAlone);
  if (vtkImageData* image = vtkImageData::SafeDownCast(data))
  {
    block.Coordinates = ImageCoordinates(image, block.Name);
  }
  else if (vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    block.Coordinates = RectilinearCoordinates(grid);
  }
  else
  {
    throw InputError(block.Name + " is a " + data->GetClassName() +
      ". Image data, uniform grids, rectilinear grids and hexahedra that form a Cartesian grid can "
      "be meshed; bring other data onto a grid first (ParaView's filter Resample To Image).");
  }
  const bool isPiece = number < 0 && !isAlone; // flat when there are fewer cells than ranks
  if (block.Data->GetNumberOfPoints() == 0 || (isPiece && IsFlat(block)))
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

std::vector<InputBlock> CollectBlocks(vtkDataObject* input, int rank, bool isAlone)
{
  std::vector<InputBlock> blocks;
  if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    int number = 0;
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem(), ++number)
    {
      AddBlock(it->GetCurrentDataObject(), number, rank, isAlone, blocks);
    }
  }
  else if (input)
  {
    AddBlock(input, -1, rank, isAlone, blocks);
  }
  return blocks;
}

} // namespace vfm
