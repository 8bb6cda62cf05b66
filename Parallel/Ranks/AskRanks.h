/**
 * AskRanks: sends items to the ranks that are responsible for them, and returns their answers.
 */
#pragma once

#include "Ranks/ItemRoute.h"

namespace vfm
{

/// Returns the ways of items.
/// @param rankOf  rankOf(item) returns the rank that gets an item
template <class Item, class RankOf>
ItemRoute MakeRoute(const std::vector<Item>& items, const RankOf& rankOf, Ranks& ranks)
{
  std::vector<int> to;
  to.reserve(items.size());
  for (const Item& item : items)
  {
    to.push_back(static_cast<int>(rankOf(item)));
  }
  return { to, ranks };
}

/// Sends items to ranks. Returns the items of all ranks to this rank, by rank, then as sent.
/// @tparam Item  trivially copyable type
/// @param rankOf  rankOf(item) returns the rank that gets an item
/// @pre Collective over `ranks`.
template <class Item, class RankOf>
std::vector<Item> SendItems(const std::vector<Item>& items, const RankOf& rankOf, Ranks& ranks)
{
  return MakeRoute(items, rankOf, ranks).Send(items);
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
  ItemRoute route = MakeRoute(items, rankOf, ranks);
  const std::vector<Item> received = route.Send(items);
  return route.Return(answer(received));
}

} // namespace vfm
