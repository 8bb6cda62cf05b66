/**
 * MergeByKey, AskByKey: combine values of the same thing, such as an edge, on all ranks that have
 * it.
 */
#pragma once

#include "Ranks/KeyMerge.h"

namespace vfm
{

/// Returns for each key the combination of all values with the same key on all ranks.
/// @tparam Key  array of ids; Value: trivially copyable
/// @param keys  may be repeated
/// @param combine (Value, Value) -> Value, commutative and associative
/// @pre Collective over `ranks`.
template <class Key, class Value, class Combine>
std::vector<Value> MergeByKey(const std::vector<Key>& keys, const std::vector<Value>& values,
  const Combine& combine, Ranks& ranks)
{
  const std::vector<std::size_t> order = OrderOf(keys);
  std::vector<Key> different;
  std::vector<Value> merged;
  for (std::size_t place : order)
  {
    if (different.empty() || different.back() < keys[place])
    {
      different.push_back(keys[place]);
      merged.push_back(values[place]);
    }
    else
    {
      merged.back() = combine(merged.back(), values[place]);
    }
  }
  KeyMerge<Key>(different, ranks)
    .Merge(merged, 1, [&combine](Value& a, const Value& b) { a = combine(a, b); });
  std::vector<Value> found(values);
  std::size_t at = 0;
  for (std::size_t place : order)
  {
    at += different[at] < keys[place] ? 1 : 0;
    found[place] = merged[at];
  }
  return found;
}

/// Returns for each question the combination of all values with this key on all ranks.
/// @tparam Key  array of ids; Value: trivially copyable
/// @param keys  of `values`; may be repeated, as questions
/// @param none  neutral value: combine(none, x) is x; the answer to unknown keys
/// @param combine (Value, Value) -> Value, commutative and associative
/// @pre Collective over `ranks`.
template <class Key, class Value, class Combine>
std::vector<Value> AskByKey(std::vector<Key> keys, std::vector<Value> values,
  const std::vector<Key>& questions, const Value& none, const Combine& combine, Ranks& ranks)
{
  const auto own = static_cast<std::ptrdiff_t>(values.size());
  keys.insert(keys.end(), questions.begin(), questions.end());
  values.resize(keys.size(), none);
  values = MergeByKey(keys, values, combine, ranks);
  values.erase(values.begin(), values.begin() + own);
  return values;
}

} // namespace vfm
