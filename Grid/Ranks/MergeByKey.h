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

/// Different keys of a list, each with the combination of its values.
template <class Key, class Value>
struct MergedList
{
  std::vector<Key> Keys; ///< ascending
  std::vector<Value> Values;
  std::vector<std::size_t> Places; ///< of each key of the list

  /// Returns the combined value for each key of the list.
  std::vector<Value> Expand() const
  {
    std::vector<Value> all;
    for (std::size_t place : this->Places)
    {
      all.push_back(this->Values[place]);
    }
    return all;
  }
};

/// @param combine (Value, Value) -> Value, commutative and associative
template <class Key, class Value, class Combine>
MergedList<Key, Value> MergeList(
  const std::vector<Key>& keys, const std::vector<Value>& values, const Combine& combine)
{
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&keys](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  MergedList<Key, Value> merged;
  merged.Places.resize(keys.size());
  for (std::size_t item : order)
  {
    if (merged.Keys.empty() || merged.Keys.back() != keys[item])
    {
      merged.Keys.push_back(keys[item]);
      merged.Values.push_back(values[item]);
    }
    else
    {
      merged.Values.back() = combine(merged.Values.back(), values[item]);
    }
    merged.Places[item] = merged.Keys.size() - 1;
  }
  return merged;
}

/// Returns for each key the combination of all values with the same key on all ranks.
/// @tparam Key  array of ids; Value: trivially copyable
/// @param keys  may be repeated
/// @param combine (Value, Value) -> Value, commutative and associative
/// @pre Collective over `ranks`.
/// @note Each rank sends and receives about as many keys as it has.
template <class Key, class Value, class Combine>
std::vector<Value> MergeByKey(const std::vector<Key>& keys, const std::vector<Value>& values,
  const Combine& combine, Ranks& ranks)
{
  MergedList<Key, Value> own = MergeList(keys, values, combine);
  if (ranks.Count() == 1)
  {
    return own.Expand();
  }
  std::vector<std::vector<Key>> sentKeys(ranks.Count());
  std::vector<std::vector<Value>> sentValues(ranks.Count());
  for (std::size_t i = 0; i < own.Keys.size(); ++i)
  {
    const int rank = MeetingRank(own.Keys[i], ranks.Count());
    sentKeys[rank].push_back(own.Keys[i]);
    sentValues[rank].push_back(own.Values[i]);
  }
  const std::vector<Bytes> receivedKeys = ExchangeAll(PackLists(sentKeys), ranks);
  const std::vector<Bytes> receivedValues = ExchangeAll(PackLists(sentValues), ranks);
  const std::vector<Value> answers =
    MergeList(JoinItems<Key>(receivedKeys), JoinItems<Value>(receivedValues), combine).Expand();
  std::vector<std::vector<Value>> returned;
  auto begin = answers.begin();
  for (const Bytes& received : receivedKeys)
  {
    const auto end = begin + static_cast<std::ptrdiff_t>(received.size() / sizeof(Key));
    returned.emplace_back(begin, end);
    begin = end;
  }
  std::vector<std::vector<Value>> lists;
  for (const Bytes& list : ExchangeAll(PackLists(returned), ranks))
  {
    lists.push_back(FromBytes<Value>(list));
  }
  std::vector<std::size_t> next(ranks.Count(), 0);
  for (std::size_t i = 0; i < own.Keys.size(); ++i)
  {
    const int rank = MeetingRank(own.Keys[i], ranks.Count());
    own.Values[i] = lists[rank][next[rank]++];
  }
  return own.Expand();
}

} // namespace vfm
