/**
 * MergeByKey: combines values of the same thing, such as an edge, on all ranks that have it.
 */
#pragma once

#include "Ranks/ExchangeAll.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace vfm
{

/// Returns the rank where ranks meet that have a thing with the same ids.
template <std::size_t N>
int MeetingRank(const std::array<std::int64_t, N>& ids, int count)
{
  std::uint64_t hash = 0;
  for (std::int64_t id : ids)
  {
    hash = (hash ^ static_cast<std::uint64_t>(id)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return static_cast<int>(hash % static_cast<std::uint64_t>(count));
}

/// Returns for each key the combination of all values with the same key in this list.
/// @param combine (Value, Value) -> Value, commutative and associative
template <class Key, class Value, class Combine>
std::vector<Value> MergeHere(
  const std::vector<Key>& keys, const std::vector<Value>& values, const Combine& combine)
{
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&keys](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  std::vector<Value> merged(values);
  for (std::size_t first = 0, last = 0; first < order.size(); first = last)
  {
    Value value = values[order[first]];
    for (last = first + 1; last < order.size() && keys[order[last]] == keys[order[first]]; ++last)
    {
      value = combine(value, values[order[last]]);
    }
    for (std::size_t i = first; i < last; ++i)
    {
      merged[order[i]] = value;
    }
  }
  return merged;
}

/// Returns for each key the combination of all values with the same key on all ranks.
/// @tparam Key  array of ids; Value: trivially copyable
/// @param combine (Value, Value) -> Value, commutative and associative
/// @pre Collective over `ranks`.
/// @note Each rank sends and receives about as many keys as it has.
template <class Key, class Value, class Combine>
std::vector<Value> MergeByKey(const std::vector<Key>& keys, const std::vector<Value>& values,
  const Combine& combine, Ranks& ranks)
{
  std::vector<Value> merged = MergeHere(keys, values, combine);
  if (ranks.Count() == 1)
  {
    return merged;
  }
  std::vector<std::vector<Key>> sentKeys(ranks.Count());
  std::vector<std::vector<Value>> sentValues(ranks.Count());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    const int rank = MeetingRank(keys[i], ranks.Count());
    sentKeys[rank].push_back(keys[i]);
    sentValues[rank].push_back(merged[i]);
  }
  const std::vector<Bytes> receivedKeys = ExchangeAll(PackLists(sentKeys), ranks);
  std::vector<Value> answers = MergeHere(JoinItems<Key>(receivedKeys),
    JoinItems<Value>(ExchangeAll(PackLists(sentValues), ranks)), combine);
  std::vector<std::vector<Value>> returned;
  auto begin = answers.begin();
  for (const Bytes& received : receivedKeys)
  {
    const auto end = begin + static_cast<std::ptrdiff_t>(received.size() / sizeof(Key));
    returned.emplace_back(begin, end);
    begin = end;
  }
  const std::vector<Bytes> mine = ExchangeAll(PackLists(returned), ranks);
  std::vector<std::vector<Value>> lists;
  for (const Bytes& list : mine)
  {
    lists.push_back(FromBytes<Value>(list));
  }
  std::vector<std::size_t> next(ranks.Count(), 0);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    const int rank = MeetingRank(keys[i], ranks.Count());
    merged[i] = lists[rank][next[rank]++];
  }
  return merged;
}

} // namespace vfm
