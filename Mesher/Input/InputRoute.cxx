#include "Input/InputRoute.h"

#include "Ranks/FindMeetings.h"

#include <set>

namespace vfm
{
namespace
{

/// A block, or the cells that a rank needs.
struct RouteBox
{
  IndexBox Owned; ///< cells of level 0 that the rank meshes
  IndexBox Block; ///< cells of the level
  int Level;      ///< level of the block; -1: not a block
  int Number;     ///< number of the block
};

/// Returns the cells of level 0 that a rank needs, or that a block overlaps.
std::vector<IndexBox> CellsOf(
  const RouteBox& box, const IndexBox& global, const std::array<bool, 3>& repeats)
{
  if (box.Level >= 0)
  {
    return { ChangeLevel(box.Block, -box.Level) };
  }
  IndexBox limits = global;
  for (int a = 0; a < 3; ++a)
  {
    limits.Lower[a] -= repeats[a] ? GhostLayers : 0;
    limits.Upper[a] += repeats[a] ? GhostLayers : 0;
  }
  return FoldIntoDomain(Grow(box.Owned, GhostLayers, limits), global, repeats);
}

/// Returns the needs and blocks of a rank.
std::vector<RouteBox> ListBoxes(const IndexBox& owned, const InputLevels& input)
{
  std::vector<RouteBox> boxes{ { owned, {}, -1, -1 } };
  for (int level = 0; level <= input.Finest(); ++level)
  {
    for (const InputBlock& block : input.Levels[level].Blocks)
    {
      boxes.push_back({ owned, block.Box, level, block.Number });
    }
  }
  return boxes;
}

} // namespace

InputRoute FindInputRoute(
  const std::vector<BlockPlace>& owners, const InputBlocks& input, int myRank, Index ghostLayers)
{
  const auto needs = [&](const IndexBox& owned)
  { return Grow(owned, ghostLayers, input.Global()); };
  const IndexBox mine = needs(BoxOfRank(owners, myRank));
  std::set<int> senders;
  for (const BlockPlace& place : input.Places)
  {
    if (Intersect(place.Box, mine).NumberOfCells() > 0)
    {
      senders.insert(place.Rank);
    }
  }
  InputRoute route;
  for (const BlockPlace& owner : owners)
  {
    const IndexBox requested = needs(owner.Box);
    const bool isReceiver = std::any_of(input.Blocks.begin(), input.Blocks.end(),
      [&requested](const InputBlock& block)
      { return Intersect(block.Box, requested).NumberOfCells() > 0; });
    if (owner.Rank != myRank && (isReceiver || senders.count(owner.Rank) > 0))
    {
      route.Peers.push_back(owner.Rank);
      route.Requested.push_back(requested);
    }
  }
  return route;
}

std::vector<BlockPlace> FindOwners(
  const IndexBox& owned, const std::array<bool, 3>& repeats, Ranks& ranks, InputLevels& input)
{
  const IndexBox global = input.Levels[0].Global();
  const std::vector<RouteBox> own = ListBoxes(owned, input);
  std::vector<RankItem<RouteBox>> near = FindMeetings(
    own, [&](const RouteBox& box) { return CellsOf(box, global, repeats); },
    [](const RouteBox& a, const RouteBox& b) { return (a.Level < 0) != (b.Level < 0); }, ranks);
  for (std::size_t b = 0; b < own.size(); ++b)
  {
    near.push_back({ own[b], ranks.Rank(), static_cast<int>(b) });
  }
  std::stable_sort(near.begin(), near.end(),
    [](const RankItem<RouteBox>& a, const RankItem<RouteBox>& b) { return a.Rank < b.Rank; });
  for (InputBlocks& level : input.Levels)
  {
    level.Places.clear();
  }
  std::vector<BlockPlace> owners;
  for (const RankItem<RouteBox>& item : near)
  {
    const RouteBox& box = item.What;
    if (owners.empty() || owners.back().Rank != item.Rank)
    {
      owners.push_back({ box.Owned, item.Rank, -1 });
    }
    if (box.Level >= 0)
    {
      input.Levels[box.Level].Places.push_back({ box.Block, item.Rank, box.Number });
    }
  }
  return owners;
}

const IndexBox& BoxOfRank(const std::vector<BlockPlace>& owners, int rank)
{
  return std::find_if(
    owners.begin(), owners.end(), [rank](const BlockPlace& owner) { return owner.Rank == rank; })
    ->Box;
}

} // namespace vfm
