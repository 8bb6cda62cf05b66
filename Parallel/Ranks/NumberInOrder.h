/**
 * NumberInOrder: numbers the items of all ranks in one order, without all items on one rank.
 */
#pragma once

#include "Ranks/Agreement.h"
#include "Ranks/AskRanks.h"

#include <numeric>

namespace vfm
{

/// Returns items that divide the items of all ranks into about equal parts, one less than ranks.
/// @pre Collective over `ranks`.
template <class Item>
std::vector<Item> FindSplitters(std::vector<Item> items, Ranks& ranks)
{
  constexpr std::size_t samples = 64; // per rank
  std::sort(items.begin(), items.end());
  std::vector<Item> chosen;
  for (std::size_t s = 0; s < std::min(samples, items.size()); ++s)
  {
    chosen.push_back(items[s * items.size() / std::min(samples, items.size())]);
  }
  chosen = UnionOverRanks(ranks, std::move(chosen));
  std::vector<Item> splitters;
  for (std::size_t r = 1; !chosen.empty() && r < static_cast<std::size_t>(ranks.Count()); ++r)
  {
    splitters.push_back(chosen[r * chosen.size() / ranks.Count()]);
  }
  return splitters;
}

/// Returns the number of each item: its position in the list of all different items.
/// @pre Collective over `ranks`. The items of a rank are above those of lower ranks.
template <class Item>
std::vector<std::int64_t> NumberOwnItems(const std::vector<Item>& items, Ranks& ranks)
{
  std::vector<Item> different(items);
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  const std::vector<std::int64_t> counts =
    GatherItems(ranks, std::vector<std::int64_t>{ static_cast<std::int64_t>(different.size()) });
  const std::int64_t first =
    std::accumulate(counts.begin(), counts.begin() + ranks.Rank(), std::int64_t(0));
  std::vector<std::int64_t> numbers;
  for (const Item& item : items)
  {
    const auto place = std::lower_bound(different.begin(), different.end(), item);
    numbers.push_back(first + (place - different.begin()));
  }
  return numbers;
}

/// Returns the position of each item, from 0, in the sorted list of the different items of all
/// ranks.
/// @tparam Item  trivially copyable type with operators < and ==
/// @param items  may be repeated, also on other ranks
/// @pre Collective over `ranks`.
/// @note Each rank sorts a part of the list (sample sort) and sends about as many items as it has.
template <class Item>
std::vector<std::int64_t> NumberInOrder(const std::vector<Item>& items, Ranks& ranks)
{
  const std::vector<Item> splitters = FindSplitters(items, ranks);
  return AskRanks(
    items,
    [&splitters](const Item& item)
    {
      return static_cast<int>(
        std::upper_bound(splitters.begin(), splitters.end(), item) - splitters.begin());
    },
    [&ranks](const std::vector<Item>& received) { return NumberOwnItems(received, ranks); }, ranks);
}

} // namespace vfm
