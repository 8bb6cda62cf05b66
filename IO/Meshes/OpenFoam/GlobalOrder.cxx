#include "Meshes/OpenFoam/GlobalOrder.h"

#include "Ranks/Agreement.h"
#include "Ranks/ExchangeAll.h"

#include <numeric>

namespace vfm
{
namespace
{

/// Sends items to the ranks that order them and returns one number per item.
/// @param rankOf  returns the rank that orders an item
/// @param answer  returns the numbers of the items received from each rank
/// @pre Collective
template <class Item, class RankOf, class Answer>
std::vector<Index> NumberByRanks(
  const std::vector<Item>& items, Ranks& ranks, const RankOf& rankOf, const Answer& answer)
{
  std::vector<std::vector<Item>> questions(ranks.Count());
  std::vector<std::vector<std::size_t>> places(ranks.Count());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    const std::size_t rank = rankOf(items[i]);
    questions[rank].push_back(items[i]);
    places[rank].push_back(i);
  }
  std::vector<std::vector<Item>> received;
  for (const Bytes& message : ExchangeAll(PackLists(questions), ranks))
  {
    received.push_back(FromBytes<Item>(message));
  }
  const std::vector<Bytes> answers = ExchangeAll(PackLists(answer(received)), ranks);
  std::vector<Index> numbers(items.size());
  for (std::size_t rank = 0; rank < answers.size(); ++rank)
  {
    const std::vector<Index> some = FromBytes<Index>(answers[rank]);
    for (std::size_t i = 0; i < some.size(); ++i)
    {
      numbers[places[rank][i]] = some[i];
    }
  }
  return numbers;
}

/// Returns the sum of the values of lower ranks.
/// @pre Collective
Index SumOfLowerRanks(Index value, Ranks& ranks)
{
  const std::vector<Index> values = GatherItems(ranks, std::vector<Index>{ value });
  return std::accumulate(values.begin(), values.begin() + ranks.Rank(), Index(0));
}

/// Returns the first number of each group of this rank, if faces are ordered by group, then rank.
/// @param counts  number of faces of each group on this rank
/// @pre Collective
std::vector<Index> FirstOfGroups(const std::vector<Index>& counts, Ranks& ranks)
{
  const std::vector<Index> all = GatherItems(ranks, counts);
  std::vector<Index> first;
  Index number = 0;
  for (std::size_t group = 0; group < counts.size(); ++group)
  {
    for (int rank = 0; rank < ranks.Count(); ++rank)
    {
      if (rank == ranks.Rank())
      {
        first.push_back(number);
      }
      number += all[rank * counts.size() + group];
    }
  }
  return first;
}

} // namespace

GlobalOrder OrderIds(const Index* ids, Index count, Ranks& ranks)
{
  GlobalOrder order;
  const Index last = static_cast<Index>(
    ranks.Max(count > 0 ? static_cast<double>(*std::max_element(ids, ids + count)) : 0.0));
  const Index width = last / ranks.Count() + 1; // range of ids of a rank
  order.Positions = NumberByRanks(
    std::vector<Index>(ids, ids + count), ranks,
    [&](Index id) { return std::min<Index>(id / width, ranks.Count() - 1); },
    [&](std::vector<std::vector<Index>>& received)
    {
      std::vector<Index> all;
      for (const std::vector<Index>& some : received)
      {
        all.insert(all.end(), some.begin(), some.end());
      }
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
      order.Total = SumOverRanks(static_cast<Index>(all.size()), ranks);
      const Index first = SumOfLowerRanks(static_cast<Index>(all.size()), ranks);
      for (std::vector<Index>& some : received)
      {
        for (Index& id : some)
        {
          id = first + (std::lower_bound(all.begin(), all.end(), id) - all.begin());
        }
      }
      return std::move(received);
    });
  return order;
}

std::vector<Index> NumberFaces(
  const std::vector<FaceCount>& counts, int groups, Index cells, Ranks& ranks)
{
  const Index width = cells / ranks.Count() + 1; // range of cells of a rank
  return NumberByRanks(
    counts, ranks, [&](const FaceCount& entry) { return entry.Cell / width; },
    [&](const std::vector<std::vector<FaceCount>>& received)
    {
      std::vector<Index> totals(groups, 0);
      std::vector<std::vector<Index>> answers;
      std::vector<std::array<Index, 4>> order; // group, cell, and place in received
      for (std::size_t rank = 0; rank < received.size(); ++rank)
      {
        for (std::size_t i = 0; i < received[rank].size(); ++i)
        {
          const FaceCount& entry = received[rank][i];
          order.push_back(
            { { entry.Group, entry.Cell, static_cast<Index>(rank), static_cast<Index>(i) } });
          totals[entry.Group] += entry.Count;
        }
        answers.emplace_back(received[rank].size());
      }
      std::sort(order.begin(), order.end());
      std::vector<Index> next = FirstOfGroups(totals, ranks);
      for (const std::array<Index, 4>& entry : order)
      {
        answers[entry[2]][entry[3]] = next[entry[0]];
        next[entry[0]] += received[entry[2]][entry[3]].Count;
      }
      return answers;
    });
}

} // namespace vfm
