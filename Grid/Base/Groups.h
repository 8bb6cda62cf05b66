/**
 * Groups: the items of numbered groups in one array, group after group. Functions
 * on lists of lists.
 */
#pragma once

#include "Base/Runtime.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace vfm
{

/// Items of the groups 0 to n-1 (compressed rows).
/// @tparam Offset  type of positions in Items
template <class Item, class Offset = Index>
struct Groups
{
  std::vector<Offset> Begin; ///< begin of each group in Items, then the number of items
  /// Items of group 0, then of group 1 and so on. The items of a group keep the
  /// order of the visits.
  std::vector<Item> Items;
};

/// Makes `count` groups.
/// @param forItems  forItems(visit) calls visit(group, item) for all items. It runs twice, to count
///   the items and to store them, and must visit the same items in the same order.
template <class Item, class Offset = Index, class ForItems>
Groups<Item, Offset> MakeGroups(std::size_t count, const ForItems& forItems)
{
  Groups<Item, Offset> groups;
  std::vector<Offset>& begin = groups.Begin;
  begin.assign(count + 1, 0);
  forItems([&](Index group, Item) { ++begin[group + 1]; });
  for (std::size_t g = 1; g <= count; ++g)
  {
    begin[g] += begin[g - 1];
  }
  groups.Items.resize(begin.back());
  std::vector<Offset> next(begin.begin(), begin.end() - 1);
  forItems([&](Index group, Item item) { groups.Items[next[group]++] = item; });
  return groups;
}

/// Returns the items of several lists, one list after another.
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

/// Calls body(i, items) for 0 <= i < count, possibly several at the same time. Returns the items
/// that the calls append, in the order of i.
/// @param block  number of calls per task
template <class Item, class Body>
std::vector<Item> CollectItems(Runtime& runtime, std::size_t count, Index block, const Body& body)
{
  const Index last = static_cast<Index>(count);
  std::vector<std::vector<Item>> found((last + block - 1) / block);
  ForEach(runtime, found.size(),
    [&](Index b)
    {
      for (Index i = b * block; i < std::min(last, (b + 1) * block); ++i)
      {
        body(i, found[b]);
      }
    });
  return Joined(found);
}

/// Returns lists of the same lengths with map(item) for each item.
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
