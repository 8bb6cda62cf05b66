#include "HostInput.h"

#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"

namespace vfm
{
namespace
{

InputBlock MakeBlock(const HostGrid& grid, const HostBox& box)
{
  InputBlock block;
  const Vector3 spacing = SpacingOf(grid, box.Level);
  for (int a = 0; a < 3; ++a)
  {
    block.Coordinates[a] = EvenNodes(grid.Origin[a], spacing[a],
      static_cast<int>(box.Cells.Lower[a]), static_cast<int>(box.Cells.Upper[a]));
  }
  const Index cells = box.Cells.NumberOfCells();
  auto arrays = std::make_shared<PlainArrays>(cells);
  for (const HostArray& array : box.Arrays)
  {
    arrays->Add(array.Name, static_cast<int>(array.Type), cells, array.Components, array.Values);
  }
  block.Arrays = arrays;
  return block;
}

} // namespace

CollectedBlocks CollectHostBlocks(const HostGrid& grid, int rank, int ranks)
{
  CollectedBlocks collected;
  for (const HostBox& box : grid.Boxes)
  {
    InputBlock block = MakeBlock(grid, box);
    block.Number = static_cast<int>(collected.Blocks.size());
    block.Name = NameBlock(block.Number, rank, ranks == 1);
    CheckCoordinates(block);
    KeepAllCells(block);
    collected.Blocks.push_back(std::move(block));
  }
  return collected;
}

} // namespace vfm
