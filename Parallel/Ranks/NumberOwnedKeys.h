/**
 * NumberOwnedKeys: numbers the keys of all ranks that a rank owns, also on ranks that only look
 * them up.
 */
#pragma once

#include "Ranks/NumberKeys.h"

namespace vfm
{

/// Numbers over all ranks of the keys of one rank.
struct OwnedKeyNumbers
{
  std::vector<std::int64_t> Numbers;   ///< of each key, from 0; -1: no rank owns it
  std::vector<unsigned char> IsShared; ///< per key, whether other ranks have it too
  std::int64_t Total;                  ///< number of different owned keys of all ranks
};

/// Numbers the different keys of all ranks that at least one rank owns, in their order. Equal keys
/// of several ranks get the same number.
/// @param keys  keys of this rank, ascending, each once
/// @param isOwned  per key, whether this rank owns it; several ranks may own the same
/// @param value  as for NumberKeys
/// @pre Collective over `ranks`.
template <class Key, class Value>
OwnedKeyNumbers NumberOwnedKeys(const std::vector<Key>& keys,
  const std::vector<unsigned char>& isOwned, const Value& value, Ranks& ranks)
{
  std::vector<std::array<int, 2>> holders; // ranks that have a key, ranks that own it
  holders.reserve(keys.size());
  for (unsigned char owns : isOwned)
  {
    holders.push_back({ { 1, owns != 0 ? 1 : 0 } });
  }
  const KeyMerge<Key> ways = MakeRisingWays(keys, value, ranks);
  holders = ways.ToHome(std::move(holders), 1,
    [](std::array<int, 2>& a, const std::array<int, 2>& b)
    {
      a[0] += b[0];
      a[1] += b[1];
    });
  const auto owned = std::count_if(
    holders.begin(), holders.end(), [](const std::array<int, 2>& h) { return h[1] > 0; });
  auto [next, total] = CountLowerAndAll(owned, ranks);
  std::vector<std::array<std::int64_t, 2>> answers; // number, ranks that have the key
  answers.reserve(holders.size());
  for (const std::array<int, 2>& h : holders)
  {
    answers.push_back({ { h[1] > 0 ? next++ : -1, h[0] } });
  }
  OwnedKeyNumbers numbers{ {}, {}, total };
  for (const std::array<std::int64_t, 2>& answer : ways.FromHome(std::move(answers), 1))
  {
    numbers.Numbers.push_back(answer[0]);
    numbers.IsShared.push_back(answer[1] > 1);
  }
  return numbers;
}

} // namespace vfm
