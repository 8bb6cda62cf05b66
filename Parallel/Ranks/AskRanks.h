/**
 * AskRanks: sends items to the ranks that are responsible for them, and returns their answers.
 */
#pragma once

#include "Ranks/ExchangeAll.h"

namespace vfm
{

/// Sends items to ranks. Returns the messages of all ranks to this rank (ToBytes), by rank; the
/// items of a rank keep their order.
/// @tparam Item  trivially copyable type
/// @param rankOf  rankOf(item) returns the rank that gets an item
/// @pre Collective over `ranks`.
template <class Item, class RankOf>
std::vector<Bytes> SendItems(const std::vector<Item>& items, const RankOf& rankOf, Ranks& ranks)
{
  std::vector<std::vector<Item>> lists(ranks.Count());
  for (const Item& item : items)
  {
    lists[rankOf(item)].push_back(item);
  }
  return ExchangeAll(PackLists(lists), ranks);
}

/// Sends items to ranks and returns one answer per item.
/// @tparam Item  trivially copyable type
/// @param rankOf  rankOf(item) returns the rank that answers for an item
/// @param answer  answer(received) returns one answer, trivially copyable, per item that all ranks
///   sent to this rank, in the same order: by rank, then as sent. It may be collective.
/// @pre Collective over `ranks`.
template <class Item, class RankOf, class Answer>
auto AskRanks(
  const std::vector<Item>& items, const RankOf& rankOf, const Answer& answer, Ranks& ranks)
{
  const std::vector<Bytes> questions = SendItems(items, rankOf, ranks);
  auto answers = answer(JoinItems<Item>(questions));
  std::vector<decltype(answers)> lists;
  auto begin = answers.begin();
  for (const Bytes& question : questions)
  {
    const auto end = begin + static_cast<std::ptrdiff_t>(question.size() / sizeof(Item));
    lists.emplace_back(begin, end);
    begin = end;
  }
  const std::vector<Bytes> received = ExchangeAll(PackLists(lists), ranks);
  for (std::size_t rank = 0; rank < received.size(); ++rank)
  {
    lists[rank] = FromBytes<typename decltype(answers)::value_type>(received[rank]);
  }
  std::vector<std::size_t> next(lists.size(), 0); // answer of each rank
  answers.clear();
  for (const Item& item : items)
  {
    const std::size_t rank = rankOf(item);
    answers.push_back(lists[rank][next[rank]++]);
  }
  return answers;
}

} // namespace vfm
