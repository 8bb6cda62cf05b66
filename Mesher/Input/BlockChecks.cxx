#include "Input/BlockChecks.h"

#include "Base/Runtime.h"
#include "Ranks/Agreement.h"
#include "Ranks/FindMeetings.h"

#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double LargestNodeKey = 0x1p59; // node ids are key * 16 + slot, in 63 bits

/// A block of a level.
struct LevelBlock
{
  IndexBox Box; ///< in cells of the level
  int Level, Number;
};

/// Returns the cells of a coarser level that a block overlaps.
IndexBox CellsOn(int level, const LevelBlock& block)
{
  return ChangeLevel(block.Box, level - block.Level);
}

bool HaveCommonCells(const LevelBlock& a, const LevelBlock& b)
{
  const int level = std::min(a.Level, b.Level);
  return Intersect(CellsOn(level, a), CellsOn(level, b)).NumberOfCells() > 0;
}

/// Two places with common cells.
using Overlap = std::array<BlockPlace, 2>;

/// Returns the first two places that overlap, in the order of their lowest layers; none if no
/// places do.
/// @param rank  rank of the first one of them; negative: any
std::optional<Overlap> FindOverlap(std::vector<BlockPlace> places, int rank)
{
  std::stable_sort(places.begin(), places.end(),
    [](const BlockPlace& a, const BlockPlace& b) { return a.Box.Lower[2] < b.Box.Lower[2]; });
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    const IndexBox& a = places[p].Box;
    const bool isOf = rank < 0 || places[p].Rank == rank;
    for (std::size_t q = p + 1; isOf && q < places.size() && places[q].Box.Lower[2] < a.Upper[2];
         ++q)
    {
      if (Intersect(a, places[q].Box).NumberOfCells() > 0)
      {
        return Overlap{ { places[p], places[q] } };
      }
    }
  }
  return {};
}

[[noreturn]] void RejectOverlap(const Overlap& overlap, bool isAlone)
{
  const auto name = [isAlone](const BlockPlace& place)
  { return NameBlock(place.Number, place.Rank, isAlone); };
  throw InputError(name(overlap[0]) + " and " + name(overlap[1]) + " overlap at " +
    TextOf(Intersect(overlap[0].Box, overlap[1].Box).Lower) +
    " of their common grid. Blocks must not overlap, except in ghost cells that the array "
    "vtkGhostType marks.");
}

/// Returns the first layer of cells across an axis, among those of a box, that blocks do not fill.
/// There must be one.
/// Collective.
Index FindOpenLayer(
  const IndexBox& box, int axis, const std::vector<InputBlock>& blocks, Ranks& ranks)
{
  std::vector<Index> layers(box.Size(axis), 0); // cells with a block
  for (const InputBlock& block : blocks)
  {
    const IndexBox common = Intersect(block.Box, box);
    for (Index layer = common.Lower[axis]; layer < common.Upper[axis]; ++layer)
    {
      layers[layer - box.Lower[axis]] += common.NumberOfCells() / common.Size(axis);
    }
  }
  ranks.Sum(layers);
  const Index filled = box.NumberOfCells() / box.Size(axis);
  return box.Lower[axis] +
    (std::find_if(layers.begin(), layers.end(), [=](Index cells) { return cells < filled; }) -
      layers.begin());
}

/// Returns the first cell without a block, x fastest; there must be one.
/// Collective.
Index3 FindGap(const InputBlocks& input, Ranks& ranks)
{
  IndexBox box = input.Global();
  for (int axis = 2; axis >= 0; --axis)
  {
    box.Lower[axis] = FindOpenLayer(box, axis, input.Blocks, ranks);
    box.Upper[axis] = box.Lower[axis] + 1;
  }
  return box.Lower;
}

} // namespace

void FindPlaces(std::span<InputBlocks> levels, Ranks& ranks)
{
  std::vector<LevelBlock> own;
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    for (const InputBlock& block : levels[level].Blocks)
    {
      own.push_back({ block.Box, static_cast<int>(level), block.Number });
    }
    levels[level].Places.clear();
  }
  const auto add = [&levels](const LevelBlock& block, int rank) {
    levels[block.Level].Places.push_back({ block.Box, rank, block.Number });
  };
  const auto near = FindMeetings(
    own, [](const LevelBlock& block) { return std::array<IndexBox, 1>{ { CellsOn(0, block) } }; },
    HaveCommonCells, ranks);
  const auto firstHigher = std::find_if(near.begin(), near.end(),
    [&ranks](const RankItem<LevelBlock>& other) { return other.Rank > ranks.Rank(); });
  std::for_each(near.begin(), firstHigher,
    [&add](const RankItem<LevelBlock>& other) { add(other.What, other.Rank); });
  std::for_each(own.begin(), own.end(), [&](const LevelBlock& block) { add(block, ranks.Rank()); });
  std::for_each(firstHigher, near.end(),
    [&add](const RankItem<LevelBlock>& other) { add(other.What, other.Rank); });
}

void CheckOverlaps(const std::vector<BlockPlace>& places, bool isAlone)
{
  if (const std::optional<Overlap> found = FindOverlap(places, -1))
  {
    RejectOverlap(*found, isAlone);
  }
}

void CheckOverlaps(std::span<const InputBlocks> levels, Ranks& ranks)
{
  std::vector<std::optional<Overlap>> found;
  std::vector<double> lowest; // layers, negative; of each level
  for (const InputBlocks& level : levels)
  {
    found.push_back(FindOverlap(level.Places, ranks.Rank()));
    lowest.push_back(found.back() ? -static_cast<double>((*found.back())[0].Box.Lower[2])
                                  : -std::numeric_limits<double>::infinity());
  }
  const std::vector<double> own = lowest;
  ranks.Max(lowest);
  std::size_t level = 0;
  while (level < levels.size() && std::isinf(lowest[level]))
  {
    ++level;
  }
  WorkTogether(ranks,
    [&]
    {
      if (level < levels.size() && own[level] == lowest[level])
      {
        RejectOverlap(*found[level], ranks.Count() == 1);
      }
    });
}

void CheckGaps(const InputBlocks& input, Ranks& ranks)
{
  Index own = 0;
  for (const InputBlock& block : input.Blocks)
  {
    own += block.Box.NumberOfCells();
  }
  const Index cells = SumOverRanks(own, ranks), filled = input.Global().NumberOfCells();
  if (cells < filled)
  {
    const Index3 gap = FindGap(input, ranks);
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
