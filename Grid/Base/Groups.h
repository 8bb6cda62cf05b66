/**
 * Groups: items of numbered groups in one array, those of a group together.
 */
#pragma once

#include "Base/IndexBox.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace vfm
{

template <class Item>
struct Groups
{
  std::vector<Index> Begin; ///< of each group in Items, and the end
  std::vector<Item> Items;  ///< in a group in the order in which they were told
};

/// forItems(visit) calls visit(group, item) for all items, the same each time: they are counted, then written.
template <class Item, class ForItems>
Groups<Item> MakeGroups(std::size_t count, const ForItems& forItems)
{
  Groups<Item> groups;
  std::vector<Index>& begin = groups.Begin;
  begin.assign(count + 1, 0);
  forItems([&](Index group, Item) { ++begin[group + 1]; });
  for (std::size_t g = 1; g <= count; ++g)
  {
    begin[g] += begin[g - 1];
  }
  groups.Items.resize(begin.back());
  std::vector<Index> next(begin.begin(), begin.end() - 1);
  forItems([&](Index group, Item item) { groups.Items[next[group]++] = item; });
  return groups;
}

/// The items of several lists, one list after another.
template <class Item>
std::vector<Item> Joined(const std::vector<std::vector<Item>>& lists)
{
  std::size_t count = 0;
  for (const std::vector<Item>& list : lists)
  {
    count += list.size();
  }
  std::vector<Item> items;
  items.reserve(count);
  for (const std::vector<Item>& list : lists)
  {
    items.insert(items.end(), list.begin(), list.end());
  }
  return items;
}

/// Lists of what map returns for the items of some lists.
template <class Item, class Map>
auto MapLists(const std::vector<std::vector<Item>>& lists, const Map& map)
{
  std::vector<std::vector<std::decay_t<decltype(map(std::declval<Item>()))>>> mapped;
  for (const std::vector<Item>& list : lists)
  {
    mapped.emplace_back();
    std::transform(list.begin(), list.end(), std::back_inserter(mapped.back()), map);
  }
  return mapped;
}

} // namespace vfm
