#include "Report/SharedPoints.h"

#include "Base/Sorted.h"
#include "Ranks/AskRanks.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// A point that this rank shares with another rank.
struct Meeting
{
  Index Id;
  Index Rank; ///< the other rank
  bool operator<(const Meeting& other) const
  {
    return this->Id != other.Id ? this->Id < other.Id : this->Rank < other.Rank;
  }
};

/// Returns, for each rank, the ids that it and others sent.
std::vector<Bytes> FindMeetings(const std::vector<Bytes>& questions)
{
  std::vector<Meeting> all; // the ranks of each id
  for (std::size_t rank = 0; rank < questions.size(); ++rank)
  {
    for (Index id : FromBytes<Index>(questions[rank]))
    {
      all.push_back({ id, static_cast<Index>(rank) });
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<std::vector<Meeting>> answers(questions.size());
  ForRuns(
    all.begin(), all.end(), [](const Meeting& a, const Meeting& b) { return a.Id == b.Id; },
    [&](auto begin, auto end)
    {
      for (auto one = begin; one != end; ++one)
      {
        std::vector<Meeting>& answer = answers[one->Rank];
        answer.insert(answer.end(), begin, one);
        answer.insert(answer.end(), one + 1, end);
      }
    });
  return PackLists(answers);
}

} // namespace

SharedPoints FindSharedPoints(const std::vector<Index>& ids, Ranks& ranks)
{
  SharedPoints shared;
  shared.IsOwned.assign(ids.size(), 1);
  if (ranks.Count() == 1)
  {
    return shared;
  }
  std::vector<Meeting> places; // ascending ids; Rank: index in ids
  for (std::size_t p = 0; p < ids.size(); ++p)
  {
    places.push_back({ ids[p], static_cast<Index>(p) });
  }
  std::sort(places.begin(), places.end());
  const auto rankOf = [&ranks](Index id) { return id % ranks.Count(); };
  auto meetings =
    JoinItems<Meeting>(ExchangeAll(FindMeetings(SendItems(ids, rankOf, ranks)), ranks));
  std::sort(meetings.begin(), meetings.end());
  auto place = places.begin();
  for (const Meeting& meeting : meetings)
  {
    while (place->Id < meeting.Id)
    {
      ++place;
    }
    shared.Places[static_cast<int>(meeting.Rank)].push_back(place->Rank);
    shared.IsOwned[place->Rank] &= meeting.Rank > ranks.Rank();
  }
  return shared;
}

} // namespace vfm
