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
  block.Coordinates = EvenCoordinates(grid.Origin, SpacingOf(grid, box.Level), box.Cells);
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

CollectedBlocks CollectHostBlocks(const HostGrid& grid, const Ranks& ranks)
{
  CollectedBlocks collected;
  for (const HostBox& box : grid.Boxes)
  {
    collected.Blocks.push_back(MakeBlock(grid, box));
    FinishBlock(collected.Blocks.back(), static_cast<int>(collected.Blocks.size()) - 1, ranks);
  }
  return collected;
}

} // namespace vfm
