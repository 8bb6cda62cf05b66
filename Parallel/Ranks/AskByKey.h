/**
 * AskByKey: entries of all ranks with a key, combined where any rank asks for the key.
 */
#pragma once

#include "Ranks/AskRanks.h"
#include "Ranks/MeetingRank.h"

#include <algorithm>

namespace vfm
{

/// Returns one answer per question: combine(first, last) of the entries of all ranks whose Key()
/// is the question.
/// @tparam Entry  trivially copyable type with Key() and operator <, which compares keys first
/// @param combine  called once per key and question, with sorted entries; none for unknown keys
/// @pre Collective over `ranks`.
template <class Entry, class Key, class Combine>
auto AskByKey(const std::vector<Entry>& entries, const std::vector<Key>& questions,
  const Combine& combine, Ranks& ranks)
{
  const int count = ranks.Count();
  const auto homeOf = [count](const Key& key) { return MeetingRank(key, count); };
  auto known = JoinItems<Entry>(SendItems(
    entries, [&homeOf](const Entry& entry) { return homeOf(entry.Key()); }, ranks));
  std::sort(known.begin(), known.end());
  const auto answer = [&known, &combine](const std::vector<Key>& keys)
  {
    std::vector<decltype(combine(known.cbegin(), known.cend()))> answers;
    for (const Key& key : keys)
    {
      const auto first = std::lower_bound(known.cbegin(), known.cend(), key,
        [](const Entry& entry, const Key& other) { return entry.Key() < other; });
      const auto last = std::upper_bound(first, known.cend(), key,
        [](const Key& other, const Entry& entry) { return other < entry.Key(); });
      answers.push_back(combine(first, last));
    }
    return answers;
  };
  return AskRanks(questions, homeOf, answer, ranks);
}

} // namespace vfm
