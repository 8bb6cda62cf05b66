/**
 * AskByKey: entries of all ranks with a key, combined where any rank asks for the key.
 */
#pragma once

#include "Ranks/ExchangeAll.h"
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
  using Answer = decltype(combine(entries.begin(), entries.end()));
  std::vector<std::vector<Entry>> toEntries(ranks.Count());
  for (const Entry& entry : entries)
  {
    toEntries[MeetingRank(entry.Key(), ranks.Count())].push_back(entry);
  }
  std::vector<std::vector<Key>> toQuestions(ranks.Count());
  std::vector<std::vector<std::size_t>> places(ranks.Count());
  for (std::size_t q = 0; q < questions.size(); ++q)
  {
    const int home = MeetingRank(questions[q], ranks.Count());
    toQuestions[home].push_back(questions[q]);
    places[home].push_back(q);
  }
  std::vector<Entry> known = JoinItems<Entry>(ExchangeAll(PackLists(toEntries), ranks));
  std::sort(known.begin(), known.end());
  std::vector<std::vector<Answer>> toAnswers;
  for (const Bytes& message : ExchangeAll(PackLists(toQuestions), ranks))
  {
    toAnswers.emplace_back();
    for (const Key& key : FromBytes<Key>(message))
    {
      const auto first = std::lower_bound(known.cbegin(), known.cend(), key,
        [](const Entry& entry, const Key& other) { return entry.Key() < other; });
      const auto last = std::upper_bound(first, known.cend(), key,
        [](const Key& other, const Entry& entry) { return other < entry.Key(); });
      toAnswers.back().push_back(combine(first, last));
    }
  }
  const std::vector<Bytes> messages = ExchangeAll(PackLists(toAnswers), ranks);
  std::vector<Answer> answers(questions.size());
  for (std::size_t home = 0; home < messages.size(); ++home)
  {
    const std::vector<Answer> own = FromBytes<Answer>(messages[home]);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      answers[places[home][i]] = own[i];
    }
  }
  return answers;
}

} // namespace vfm
