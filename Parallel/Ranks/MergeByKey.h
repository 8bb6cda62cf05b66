/**
 * MergeByKey: combines values of the same thing, such as an edge, on all ranks that have it.
 */
#pragma once

#include "Ranks/AskByKey.h"

#include <numeric>

namespace vfm
{

/// Returns for each key the combination of all values with the same key on all ranks.
/// @tparam Key  array of ids; Value: trivially copyable
/// @param keys  may be repeated
/// @param combine (Value, Value) -> Value, commutative and associative
/// @pre Collective over `ranks`.
template <class ItemKey, class Value, class Combine>
std::vector<Value> MergeByKey(const std::vector<ItemKey>& keys, const std::vector<Value>& values,
  const Combine& combine, Ranks& ranks)
{
  struct Item
  {
    ItemKey Ids;
    Value Own;
    const ItemKey& Key() const { return this->Ids; }
    bool operator<(const Item& other) const { return this->Ids < other.Ids; }
  };
  std::vector<Item> items;
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    items.push_back({ keys[i], values[i] });
  }
  const auto fold = [&combine](auto first, auto last)
  {
    return std::accumulate(first + 1, last, first->Own,
      [&combine](const Value& sum, const Item& item) { return combine(sum, item.Own); });
  };
  return AskByKey(items, keys, fold, ranks);
}

} // namespace vfm
