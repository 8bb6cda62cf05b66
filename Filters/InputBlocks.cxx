#include "InputBlocks.h"

#include "Runtime.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkUniformGrid.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double MatchTolerance = 1e-3;   // of the smallest cell width
constexpr double LargestNodeKey = 0x1p59; // node ids are key * 16 + slot, in 63 bits
constexpr const char* AxisNames[3] = { "x", "y", "z" };

[[noreturn]] void Refuse(const std::string& message)
{
  throw InputError(message);
}

std::string Text(const Index3& cell)
{
  std::ostringstream text;
  text << "cell (" << cell[0] << ", " << cell[1] << ", " << cell[2] << ")";
  return text.str();
}

/// The only level of an AMR that holds blocks; its other levels are refused.
void CheckOneLevel(vtkUniformGridAMR* amr)
{
  int levels = 0;
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    bool used = false;
    for (unsigned int i = 0; i < amr->GetNumberOfDataSets(level); ++i)
    {
      used = used || amr->GetDataSet(level, i);
    }
    levels += used;
  }
  if (levels > 1)
  {
    Refuse("The input is refined (AMR) and has blocks on " + std::to_string(levels) +
      " levels. Refined grids are not supported yet: extract one level (filter Extract Level), "
      "or resample to an image (filter Resample To Image).");
  }
}

std::array<std::vector<double>, 3> ImageCoordinates(vtkImageData* image, const std::string& name)
{
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    Refuse(name +
      " is an image with a rotated direction matrix. Set the direction matrix to the "
      "identity and rotate the mesh instead (filter Transform).");
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

void CheckCoordinates(const InputBlock& block)
{
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = block.Coordinates[a];
    if (x.size() < 2)
    {
      Refuse(block.Name + " is flat: it has no cells along " + AxisNames[a] +
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
        Refuse(text.str());
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
  for (Index k = 0; k < block.Dimensions[2]; ++k)
  {
    for (Index j = 0; j < block.Dimensions[1]; ++j)
    {
      for (Index i = 0; i < block.Dimensions[0]; ++i, ++id)
      {
        if (types[id] & vtkDataSetAttributes::DUPLICATECELL)
        {
          continue;
        }
        ++kept;
        const Index3 cell{ { i, j, k } };
        for (int a = 0; a < 3; ++a)
        {
          box.Lower[a] = std::min(box.Lower[a], cell[a]);
          box.Upper[a] = std::max(box.Upper[a], cell[a] + 1);
        }
      }
    }
  }
  if (kept > 0 && kept != box.NumberOfCells())
  {
    Refuse(block.Name +
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

void AddBlock(vtkDataObject* data, const std::string& name, std::vector<InputBlock>& blocks)
{
  InputBlock block;
  block.Data = vtkDataSet::SafeDownCast(data);
  block.Name = name;
  if (vtkImageData* image = vtkImageData::SafeDownCast(data))
  {
    block.Coordinates = ImageCoordinates(image, name);
  }
  else if (vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    block.Coordinates = RectilinearCoordinates(grid);
  }
  else
  {
    Refuse(name + " is a " + data->GetClassName() +
      ". Image data, uniform grids and rectilinear grids can be meshed; bring other data onto a "
      "grid first (filter Resample To Image).");
  }
  if (block.Data->GetNumberOfPoints() == 0)
  {
    return;
  }
  CheckCoordinates(block);
  if (DropGhosts(block))
  {
    blocks.push_back(std::move(block));
  }
}

std::vector<InputBlock> CollectBlocks(vtkDataObject* input)
{
  std::vector<InputBlock> blocks;
  if (vtkUniformGridAMR* amr = vtkUniformGridAMR::SafeDownCast(input))
  {
    CheckOneLevel(amr);
  }
  if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    int number = 0;
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem(), ++number)
    {
      AddBlock(it->GetCurrentDataObject(), "Block " + std::to_string(number), blocks);
    }
  }
  else if (input)
  {
    AddBlock(input, "The input", blocks);
  }
  if (blocks.empty())
  {
    Refuse("The input has no cells. Volume fractions on a 3D grid of cells are needed.");
  }
  return blocks;
}

/// Node coordinates of all blocks along an axis, those closer than tolerance merged.
std::vector<double> MergeCoordinates(
  const std::vector<InputBlock>& blocks, int axis, double tolerance)
{
  std::vector<double> all, merged;
  for (const InputBlock& block : blocks)
  {
    all.insert(all.end(), block.Coordinates[axis].begin(), block.Coordinates[axis].end());
  }
  std::sort(all.begin(), all.end());
  for (double x : all)
  {
    if (merged.empty() || x - merged.back() > tolerance)
    {
      merged.push_back(x);
    }
  }
  return merged;
}

/// Finds the cells of the block along an axis of the global grid.
void PlaceBlock(InputBlock& block, int axis, const std::vector<double>& global)
{
  const std::vector<double>& x = block.Coordinates[axis];
  auto node = [&global](double value)
  { return std::upper_bound(global.begin(), global.end(), value) - global.begin() - 1; };
  block.Box.Lower[axis] = node(x.front());
  block.Box.Upper[axis] = node(x.back());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    if (node(x[i]) != block.Box.Lower[axis] + static_cast<Index>(i))
    {
      std::ostringstream text;
      text << block.Name << " does not fit the other blocks along " << AxisNames[axis] << " near "
           << x[i] << ": another block has nodes between its own. All blocks must lie on one grid "
           << "with the same spacing; refined (AMR) grids are not supported yet.";
      Refuse(text.str());
    }
  }
}

void CheckOverlaps(const std::vector<InputBlock>& blocks)
{
  std::vector<const InputBlock*> sorted;
  for (const InputBlock& block : blocks)
  {
    sorted.push_back(&block);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const InputBlock* a, const InputBlock* b) { return a->Box.Lower[2] < b->Box.Lower[2]; });
  for (std::size_t p = 0; p < sorted.size(); ++p)
  {
    const IndexBox& a = sorted[p]->Box;
    for (std::size_t q = p + 1; q < sorted.size() && sorted[q]->Box.Lower[2] < a.Upper[2]; ++q)
    {
      const IndexBox& b = sorted[q]->Box;
      const Index3 first{ { std::max(a.Lower[0], b.Lower[0]), std::max(a.Lower[1], b.Lower[1]),
        std::max(a.Lower[2], b.Lower[2]) } };
      if (a.Contains(first) && b.Contains(first))
      {
        Refuse(sorted[p]->Name + " and " + sorted[q]->Name + " overlap at " + Text(first) +
          " of their common grid. Blocks must not overlap, except in ghost cells that the array "
          "vtkGhostType marks.");
      }
    }
  }
}

/// The first cell that no block holds, given that there is one.
Index3 FindGap(const InputBlocks& input)
{
  const auto end = [&input](int a) { return static_cast<Index>(input.Coordinates[a].size()) - 1; };
  for (Index k = 0; k < end(2); ++k)
  {
    for (Index j = 0, nextRow = 0; j < end(1); j = nextRow)
    {
      nextRow = end(1);
      for (Index i = 0; i < end(0);)
      {
        const InputBlock* found = nullptr;
        for (int b : input.Layers[k])
        {
          found = input.Blocks[b].Box.Contains({ { i, j, k } }) ? &input.Blocks[b] : found;
        }
        if (!found)
        {
          return { { i, j, k } };
        }
        i = found->Box.Upper[0];
        nextRow = std::min(nextRow, found->Box.Upper[1]); // until then every row is like this one
      }
    }
  }
  return { { 0, 0, 0 } };
}

void CheckGaps(const InputBlocks& input)
{
  Index cells = 0, filled = 1;
  for (const InputBlock& block : input.Blocks)
  {
    cells += block.Box.NumberOfCells();
  }
  for (int a = 0; a < 3; ++a)
  {
    filled *= static_cast<Index>(input.Coordinates[a].size()) - 1;
  }
  if (cells < filled)
  {
    const Index3 gap = FindGap(input);
    std::ostringstream text;
    text << "The blocks leave a gap: " << filled - cells << " of the " << filled
         << " cells of their common grid are in no block, the first is " << Text(gap) << " at ("
         << input.Coordinates[0][gap[0]] << ", " << input.Coordinates[1][gap[1]] << ", "
         << input.Coordinates[2][gap[2]] << "). Blocks must fill a box.";
    Refuse(text.str());
  }
}

void CheckIds(const InputBlocks& input)
{
  double nodes = 1.0;
  for (const std::vector<double>& x : input.Coordinates)
  {
    nodes *= static_cast<double>(x.size());
  }
  if (nodes >= LargestNodeKey)
  {
    std::ostringstream text;
    text << "The grid has " << nodes << " nodes, more than 64-bit ids can number ("
         << LargestNodeKey << "). Mesh a part of it (filter Extract Subset).";
    Refuse(text.str());
  }
}

} // namespace

InputBlocks FindInputBlocks(vtkDataObject* data)
{
  InputBlocks input;
  input.Blocks = CollectBlocks(data);
  for (int a = 0; a < 3; ++a)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const InputBlock& block : input.Blocks)
    {
      for (std::size_t i = 1; i < block.Coordinates[a].size(); ++i)
      {
        least = std::min(least, block.Coordinates[a][i] - block.Coordinates[a][i - 1]);
      }
    }
    input.Coordinates[a] = MergeCoordinates(input.Blocks, a, MatchTolerance * least);
    for (InputBlock& block : input.Blocks)
    {
      PlaceBlock(block, a, input.Coordinates[a]);
    }
  }
  CheckIds(input);
  input.Layers.resize(input.Coordinates[2].size() - 1);
  for (std::size_t b = 0; b < input.Blocks.size(); ++b)
  {
    const IndexBox& box = input.Blocks[b].Box;
    for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
    {
      input.Layers[k].push_back(static_cast<int>(b));
    }
  }
  CheckOverlaps(input.Blocks);
  CheckGaps(input);
  return input;
}

} // namespace vfm
