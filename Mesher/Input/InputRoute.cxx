#include "Input/InputRoute.h"

#include <set>

namespace vfm
{

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

const IndexBox& BoxOfRank(const std::vector<BlockPlace>& owners, int rank)
{
  return std::find_if(
    owners.begin(), owners.end(), [rank](const BlockPlace& owner) { return owner.Rank == rank; })
    ->Box;
}

} // namespace vfm
