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

/// Returns the points of this rank that other ranks have too, once per other rank. Ranks that share
/// a point meet on the rank that its id determines.
/// @pre Collective
std::vector<Meeting> FindSharers(const std::vector<Index>& ids, Ranks& ranks)
{
  ItemRoute route = MakeRoute(
    ids, [&ranks](Index id) { return id % ranks.Count(); }, ranks);
  std::vector<Meeting> all; // the ranks of each id
  for (Index id : route.Send(ids))
  {
    all.push_back({ id, 0 });
  }
  auto next = all.begin();
  for (const ItemRoute::Run& run : route.Received())
  {
    for (const auto end = next + run.Count; next != end; ++next)
    {
      next->Rank = run.Source;
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<Meeting> answers;
  std::vector<int> to;
  ForRuns(
    all.begin(), all.end(), [](const Meeting& a, const Meeting& b) { return a.Id == b.Id; },
    [&](auto begin, auto end)
    {
      for (auto one = begin; one != end; ++one)
      {
        answers.insert(answers.end(), begin, one);
        answers.insert(answers.end(), one + 1, end);
        to.resize(answers.size(), static_cast<int>(one->Rank));
      }
    });
  return ItemRoute(to, ranks).Send(answers);
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
  std::vector<Meeting> meetings = FindSharers(ids, ranks);
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
