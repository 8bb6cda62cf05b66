#include "InputBlocks.h"

#include "Agreement.h"
#include "CollectBlocks.h"
#include "FindNeighbours.h"
#include "MakePartition.h"
#include "NodeCoordinates.h"
#include "Runtime.h"

#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

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

/// Its other levels would cover the blocks of the first.
void CheckLevels(const std::vector<int>& used)
{
  if (used.size() > 1)
  {
    Refuse("The input is refined (AMR) and has blocks on " + std::to_string(used.size()) +
      " levels. Refined grids are not supported yet: extract one level (filter Extract Level), "
      "or resample to an image (filter Resample To Image).");
  }
}

double FindSmallestWidth(const std::vector<InputBlock>& blocks, int axis)
{
  double least = std::numeric_limits<double>::infinity();
  for (const InputBlock& block : blocks)
  {
    const std::vector<double>& x = block.Coordinates[axis];
    for (std::size_t i = 1; i < x.size(); ++i)
    {
      least = std::min(least, x[i] - x[i - 1]);
    }
  }
  return least;
}

/// Collective: node coordinates of all blocks along an axis, those that are close merged.
std::vector<double> MergeCoordinates(const std::vector<InputBlock>& blocks, int axis, Ranks& ranks)
{
  const double width = -ranks.Max(-FindSmallestWidth(blocks, axis));
  std::vector<double> mine;
  for (const InputBlock& block : blocks)
  {
    mine.insert(mine.end(), block.Coordinates[axis].begin(), block.Coordinates[axis].end());
  }
  return MergeClose(Unite(ranks, std::move(mine)), width);
}

/// Finds the cells of the block along an axis of the global grid.
void PlaceBlock(InputBlock& block, int axis, const std::vector<double>& global)
{
  const std::vector<double>& x = block.Coordinates[axis];
  const auto node = [&global](double value) { return FindNode(global, value); };
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

void PlaceBlocks(InputBlocks& input)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (InputBlock& block : input.Blocks)
    {
      PlaceBlock(block, axis, input.Coordinates[axis]);
    }
  }
}

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
        Refuse(name(places[p]) + " and " + name(places[q]) + " overlap at " + Text(common.Lower) +
          " of their common grid. Blocks must not overlap, except in ghost cells that the array "
          "vtkGhostType marks.");
      }
    }
  }
}

/// The first cell that no block holds, given that there is one.
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
        nextRow = std::min(nextRow, (*found)->Upper[1]); // until then every row is like this one
      }
    }
  }
  return { { 0, 0, 0 } };
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

/// Collective: the blocks of this rank in the grid of all.
InputBlocks FindOwnBlocks(vtkDataObject* data, Ranks& ranks)
{
  InputBlocks input;
  CheckLevels(Unite(ranks, FindUsedLevels(data)));
  WorkTogether(
    ranks, [&] { input.Blocks = CollectBlocks(data, ranks.Rank(), ranks.Count() == 1); });
  if (!ranks.Any(!input.Blocks.empty()))
  {
    Refuse("The input has no cells. Volume fractions on a 3D grid of cells are needed.");
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    input.Coordinates[axis] = MergeCoordinates(input.Blocks, axis, ranks);
  }
  CheckIds(input);
  WorkTogether(ranks, [&input] { PlaceBlocks(input); });
  return input;
}

/// The places of this rank's block and of those that the neighbours have, by rank.
std::vector<BlockPlace> FindPlacesAround(
  const IndexBox& box, const std::array<int, 6>& faces, Ranks& ranks)
{
  RankBox mine{ ranks.Rank(), {}, {} };
  for (int a = 0; a < 3; ++a)
  {
    mine.Lower[a] = static_cast<double>(box.Lower[a]);
    mine.Upper[a] = static_cast<double>(box.Upper[a]);
  }
  std::vector<BlockPlace> places{ { box, mine.Rank, -1 } };
  for (const RankBox& other : FindNeighbours(mine, faces, ranks, GhostLevels))
  {
    BlockPlace place{ {}, other.Rank, -1 };
    for (int a = 0; a < 3; ++a)
    {
      place.Box.Lower[a] = static_cast<Index>(other.Lower[a]);
      place.Box.Upper[a] = static_cast<Index>(other.Upper[a]);
    }
    places.push_back(place);
  }
  std::sort(places.begin(), places.end(),
    [](const BlockPlace& a, const BlockPlace& b) { return a.Rank < b.Rank; });
  return places;
}

/// Overlaps must have been ruled out.
void CheckGhostCells(const InputBlocks& input, int rank)
{
  const IndexBox local = Grow(input.Blocks[0].Box, GhostLevels, input.Global());
  Index missing = local.NumberOfCells();
  for (const BlockPlace& place : input.Places)
  {
    missing -= Intersect(place.Box, local).NumberOfCells();
  }
  if (missing > 0)
  {
    Refuse("The face neighbours of rank " + std::to_string(rank) + " do not lead to " +
      std::to_string(missing) +
      " of the cells around its box. Every side of a box that is not on the side of the "
      "whole grid needs the rank across it.");
  }
}

} // namespace

InputBlocks FindInputBlocks(vtkDataObject* data, Ranks& ranks)
{
  InputBlocks input = FindOwnBlocks(data, ranks);
  input.Places = GatherPlaces(input.Blocks, ranks);
  CheckOverlaps(input.Places, ranks.Count() == 1);
  CheckGaps(input);
  return input;
}

InputBlocks FindNeighbourBlocks(vtkDataObject* data, const std::array<int, 6>& faces, Ranks& ranks)
{
  InputBlocks input = FindOwnBlocks(data, ranks);
  WorkTogether(ranks,
    [&]
    {
      if (input.Blocks.size() != 1)
      {
        Refuse("Rank " + std::to_string(ranks.Rank()) + " has " +
          std::to_string(input.Blocks.size()) +
          " blocks. With face neighbours every rank must have one.");
      }
    });
  input.Places = FindPlacesAround(input.Blocks[0].Box, faces, ranks);
  WorkTogether(ranks,
    [&]
    {
      CheckOverlaps(input.Places, ranks.Count() == 1);
      CheckGhostCells(input, ranks.Rank());
    });
  return input;
}

} // namespace vfm
