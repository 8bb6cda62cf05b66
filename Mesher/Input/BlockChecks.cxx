#include "Input/BlockChecks.h"

#include "Base/Runtime.h"

#include <sstream>

namespace vfm
{
namespace
{

constexpr double LargestNodeKey = 0x1p59; // node ids are key * 16 + slot, in 63 bits

/// Returns the first cell without a block; there must be one.
Index3 FindGap(const IndexBox& global, const std::vector<BlockPlace>& places)
{
  for (Index k = 0; k < global.Upper[2]; ++k)
  {
    std::vector<const IndexBox*> layer;
    for (const BlockPlace& place : places)
    {
      if (place.Box.Lower[2] <= k && k < place.Box.Upper[2])
      {
        layer.push_back(&place.Box);
      }
    }
    for (Index j = 0, nextRow = 0; j < global.Upper[1]; j = nextRow)
    {
      nextRow = global.Upper[1];
      for (Index i = 0; i < global.Upper[0];)
      {
        const Index3 cell{ { i, j, k } };
        const auto found = std::find_if(
          layer.begin(), layer.end(), [&cell](const IndexBox* box) { return box->Contains(cell); });
        if (found == layer.end())
        {
          return cell;
        }
        i = (*found)->Upper[0];
        nextRow = std::min(nextRow, (*found)->Upper[1]); // rows before are equal to this one
      }
    }
  }
  return { { 0, 0, 0 } };
}

} // namespace

std::vector<BlockPlace> GatherPlaces(const std::vector<InputBlock>& blocks, Ranks& ranks)
{
  std::vector<BlockPlace> mine;
  for (const InputBlock& block : blocks)
  {
    mine.push_back({ block.Box, ranks.Rank(), block.Number });
  }
  return GatherItems(ranks, mine);
}

void CheckOverlaps(std::vector<BlockPlace> places, bool isAlone)
{
  const auto name = [isAlone](const BlockPlace& place)
  { return NameBlock(place.Number, place.Rank, isAlone); };
  std::stable_sort(places.begin(), places.end(),
    [](const BlockPlace& a, const BlockPlace& b) { return a.Box.Lower[2] < b.Box.Lower[2]; });
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    const IndexBox& a = places[p].Box;
    for (std::size_t q = p + 1; q < places.size() && places[q].Box.Lower[2] < a.Upper[2]; ++q)
    {
      const IndexBox common = Intersect(a, places[q].Box);
      if (common.NumberOfCells() > 0)
      {
        throw InputError(name(places[p]) + " and " + name(places[q]) + " overlap at " +
          TextOf(common.Lower) +
          " of their common grid. Blocks must not overlap, except in ghost cells that the array "
          "vtkGhostType marks.");
      }
    }
  }
}

void CheckGaps(const InputBlocks& input)
{
  Index cells = 0;
  const Index filled = input.Global().NumberOfCells();
  for (const BlockPlace& place : input.Places)
  {
    cells += place.Box.NumberOfCells();
  }
  if (cells < filled)
  {
    const Index3 gap = FindGap(input.Global(), input.Places);
    std::ostringstream text;
    text << "The blocks leave a gap: " << filled - cells << " of the " << filled
         << " cells of their common grid are in no block, the first is " << TextOf(gap) << " at ("
         << input.Coordinates[0][gap[0]] << ", " << input.Coordinates[1][gap[1]] << ", "
         << input.Coordinates[2][gap[2]] << "). Blocks must fill a box.";
    throw InputError(text.str());
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
         << LargestNodeKey << "). Mesh a part of it (ParaView's filter Extract Subset).";
    throw InputError(text.str());
  }
}

} // namespace vfm
