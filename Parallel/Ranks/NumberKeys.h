/**
 * NumberKeys: numbers the different keys of all ranks in their order, in log2 P messages per rank.
 */
#pragma once

#include "Ranks/KeyMerge.h"

#include <cmath>
#include <limits>

namespace vfm
{

/// Returns the sum of each value over all lower ranks. log2 P messages per rank.
/// @param mine  values of this rank, as many on all ranks
/// @pre Collective over `ranks`.
std::vector<std::int64_t> SumOfLowerRanks(const std::vector<std::int64_t>& mine, Ranks& ranks);

/// Returns the sum of the values of all lower ranks.
/// @pre Collective over `ranks`.
inline std::int64_t SumOfLowerRanks(std::int64_t mine, Ranks& ranks)
{
  return SumOfLowerRanks(std::vector<std::int64_t>{ mine }, ranks)[0];
}

/// Homes that rise with values, with about equal numbers of values. Values are divided into 64
/// equal ranges per home, at most 4,096, those with far too many values again, and a home has some
/// of them.
class RisingHomes
{
public:
  /// @param values  values of this rank, in any order
  /// @pre Collective over `ranks`.
  RisingHomes(const std::vector<std::int64_t>& values, Ranks& ranks);
  /// Returns the home of a value of any rank.
  int operator()(std::int64_t value) const { return this->HomeOfRange[this->RangeOf(value)]; }

private:
  struct Range
  {
    std::int64_t Start; // lowest value
    int Shift;          // it has 2^Shift values
    std::int64_t Count; // values of all ranks in it; -1: not counted
  };
  static void AddRanges(
    std::int64_t start, int shift, std::size_t count, std::vector<Range>& ranges);
  std::size_t RangeOf(std::int64_t value) const;
  void Count(const std::vector<std::int64_t>& values, Ranks& ranks);
  bool Divide(std::int64_t most);

  std::size_t NumberOfRanges; // of each division
  std::vector<Range> Ranges;  // ascending; the first and the last have all values outside
  std::vector<int> HomeOfRange;
};

/// Numbers of keys in the order of the different keys of all ranks.
struct KeyNumbers
{
  std::vector<std::int64_t> Numbers; ///< of each key of this rank, from 0
  std::int64_t Total;                ///< number of different keys of all ranks
};

/// Ways of keys to homes that rise with them.
/// @param keys, value  as for NumberKeys
/// @pre Collective over `ranks`.
template <class Key, class Value>
KeyMerge<Key> MakeRisingWays(const std::vector<Key>& keys, const Value& value, Ranks& ranks)
{
  std::vector<std::int64_t> values;
  values.reserve(keys.size());
  for (const Key& key : keys)
  {
    values.push_back(value(key));
  }
  const RisingHomes homes(values, ranks);
  return KeyMerge<Key>(
    keys, [&](const Key& key) { return homes(value(key)); }, ranks);
}

/// Returns the number of items on lower ranks, and on all ranks.
/// @param count  of this rank
/// @pre Collective over `ranks`.
std::pair<std::int64_t, std::int64_t> CountLowerAndAll(std::int64_t count, Ranks& ranks);

/// Numbers the different keys of all ranks in their order. Equal keys of several ranks get the same
/// number.
/// @param keys  keys of this rank, ascending, each once
/// @param value  value(key) is an integer that never falls as keys rise; keys may have equal
///   values, which get one home, so few keys should have the same
/// @pre Collective over `ranks`.
template <class Key, class Value>
KeyNumbers NumberKeys(const std::vector<Key>& keys, const Value& value, Ranks& ranks)
{
  const KeyMerge<Key> ways = MakeRisingWays(keys, value, ranks);
  std::vector<std::int64_t> numbers(ways.HomeKeys().size());
  const auto [before, total] = CountLowerAndAll(static_cast<std::int64_t>(numbers.size()), ranks);
  std::iota(numbers.begin(), numbers.end(), before);
  return { ways.FromHome(std::move(numbers), 1), total };
}

/// Value of a key for NumberKeys: the number, or the first of several.
struct FirstOfKey
{
  std::int64_t operator()(std::int64_t key) const { return key; }
  template <std::size_t Length>
  std::int64_t operator()(const std::array<std::int64_t, Length>& key) const
  {
    return key[0];
  }
};

/// Value for NumberKeys of keys that begin with a group, such as a block, and an id.
class ValueInGroup
{
public:
  /// @param greatest  greatest id of all ranks; ids are at least 0
  explicit ValueInGroup(std::int64_t greatest)
  {
    while (greatest >> this->Shift >= std::int64_t(1) << 40) // groups must fit, up to 2^22
    {
      ++this->Shift;
    }
    this->Width = (greatest >> this->Shift) + 1;
  }
  std::int64_t operator()(std::int64_t group, std::int64_t id) const
  {
    return group * this->Width + (id >> this->Shift);
  }

private:
  int Shift = 0;
  std::int64_t Width;
};

/// Numbers the different items of all ranks in their order.
/// @param items  of this rank, in any order; may be repeated
/// @param value  as in NumberKeys
/// @return the number of each item: its position in the list of the different items of all ranks
/// @pre Collective over `ranks`.
template <class Item, class Value>
KeyNumbers NumberItems(const std::vector<Item>& items, const Value& value, Ranks& ranks)
{
  const std::vector<std::size_t> order = OrderOf(items);
  std::vector<Item> different;
  for (std::size_t place : order)
  {
    if (different.empty() || different.back() < items[place])
    {
      different.push_back(items[place]);
    }
  }
  const KeyNumbers keys = NumberKeys(different, value, ranks);
  KeyNumbers found{ std::vector<std::int64_t>(items.size()), keys.Total };
  std::size_t at = 0;
  for (std::size_t place : order)
  {
    at += different[at] < items[place] ? 1 : 0;
    found.Numbers[place] = keys.Numbers[at];
  }
  return found;
}

} // namespace vfm
