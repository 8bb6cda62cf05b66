/**
 * ItemRoute: sends items to ranks, and answers back, in log2 P messages per rank, whoever gets
 * them.
 *
 * Items travel along the edges of a hypercube of ranks: one bit of the number of the rank after the
 * other. Items between the same two ranks travel together. The way is stored for the answers.
 *
 *      rank 3 (11) --- bit 0 ---> rank 2 (10) --- bit 1 ---> rank 0 (00)
 */
#pragma once

#include "Ranks/Ranks.h"

namespace vfm
{

/// Ways of items of all ranks to other ranks. The ranks must outlive it. A rank with all items for
/// itself sends only empty messages; a single rank sends none.
class ItemRoute
{
public:
  /// Items that travel together.
  struct Run
  {
    int Source, To; ///< ranks
    std::int64_t Count;
  };

  /// @param to  rank that gets each item of this rank
  ItemRoute(const std::vector<int>& to, Ranks& ranks);

  /// Sends items, and stores their ways. To be called once.
  /// @param items  as many as ranks in the constructor; trivially copyable
  /// @return the items that all ranks sent to this rank: by rank, then as sent
  /// @pre Collective.
  template <class Item>
  std::vector<Item> Send(const std::vector<Item>& items)
  {
    std::vector<Item> sorted;
    sorted.reserve(items.size());
    for (std::size_t place : this->Order)
    {
      sorted.push_back(items[place]);
    }
    return FromBytes<Item>(this->SendBytes(ToBytes(sorted), sizeof(Item)));
  }

  /// Returns the runs of the items that Send returned, by source.
  const std::vector<Run>& Received() const { return this->Runs.back(); }

  /// Sends answers back.
  /// @param answers  one per item that Send returned; trivially copyable
  /// @return one answer per item of this rank
  /// @pre Collective, after Send.
  template <class Answer>
  std::vector<Answer> Return(const std::vector<Answer>& answers) const
  {
    const auto sorted = FromBytes<Answer>(this->ReturnBytes(ToBytes(answers), sizeof(Answer)));
    std::vector<Answer> own(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
      own[this->Order[i]] = sorted[i];
    }
    return own;
  }

private:
  /// Exchange with one rank. Runs are positions in Runs before and after it.
  struct Stage
  {
    int Partner;
    std::vector<unsigned char> IsSent;     // before
    std::vector<unsigned char> IsReceived; // after
  };

  Bytes SendBytes(Bytes items, std::size_t width);
  Bytes ReturnBytes(Bytes answers, std::size_t width) const;
  template <class IsSent>
  void AddStage(int partner, std::size_t width, const IsSent& isSent, Bytes& items);

  Ranks* Group;
  std::vector<std::size_t> Order;     // items of this rank by the ranks that get them
  std::vector<std::vector<Run>> Runs; // before the first stage and after each one: by Source and To
  std::vector<Stage> Stages;
};

} // namespace vfm
