#include "Meshes/OpenFoam/GlobalOrder.h"

#include "Ranks/AskRanks.h"
#include "Ranks/NumberKeys.h"

namespace vfm
{
namespace
{

/// Returns the first number of each group of this rank, if faces are ordered by group, then rank.
/// @param counts  number of faces of each group on this rank
/// @pre Collective
std::vector<Index> FirstOfGroups(const std::vector<Index>& counts, Ranks& ranks)
{
  std::vector<Index> first = SumOfLowerRanks(counts, ranks), totals = counts;
  ranks.Sum(totals);
  Index before = 0;
  for (std::size_t group = 0; group < counts.size(); ++group)
  {
    first[group] += before;
    before += totals[group];
  }
  return first;
}

} // namespace

GlobalOrder OrderIds(const Index* ids, Index count, Ranks& ranks)
{
  KeyNumbers numbers = NumberItems(std::vector<Index>(ids, ids + count), FirstOfKey(), ranks);
  return { std::move(numbers.Numbers), numbers.Total };
}

std::vector<Index> NumberFaces(
  const std::vector<FaceCount>& counts, int groups, Index cells, Ranks& ranks)
{
  const Index width = cells / ranks.Count() + 1; // range of cells of a rank
  return AskRanks(
    counts, [&](const FaceCount& entry) { return entry.Cell / width; },
    [&](const std::vector<FaceCount>& received)
    {
      std::vector<Index> totals(groups, 0);
      std::vector<std::array<Index, 3>> order; // group, cell, and place in received
      for (std::size_t i = 0; i < received.size(); ++i)
      {
        order.push_back({ { received[i].Group, received[i].Cell, static_cast<Index>(i) } });
        totals[received[i].Group] += received[i].Count;
      }
      std::sort(order.begin(), order.end());
      std::vector<Index> next = FirstOfGroups(totals, ranks), first(received.size());
      for (const auto& [group, cell, place] : order)
      {
        first[place] = next[group];
        next[group] += received[place].Count;
      }
      return first;
    },
    ranks);
}

} // namespace vfm
