#include "Ranks/ItemRoute.h"

#include "Ranks/KeyMerge.h"

#include <numeric>
#include <tuple>

namespace vfm
{
namespace
{

using Run = ItemRoute::Run;

/// Divides the items of runs into two lists.
/// @param isSecond  of each run
std::array<Bytes, 2> Divide(const Bytes& items, const std::vector<Run>& runs,
  const std::vector<unsigned char>& isSecond, std::size_t width)
{
  std::array<Bytes, 2> lists;
  auto at = items.begin();
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const auto end = at + static_cast<std::ptrdiff_t>(width * runs[r].Count);
    lists[isSecond[r]].insert(lists[isSecond[r]].end(), at, end);
    at = end;
  }
  return lists;
}

/// Joins the items of runs from two lists.
/// @param isSecond  of each run
Bytes Join(const std::array<Bytes, 2>& lists, const std::vector<Run>& runs,
  const std::vector<unsigned char>& isSecond, std::size_t width)
{
  Bytes items;
  items.reserve(lists[0].size() + lists[1].size());
  std::array<Bytes::const_iterator, 2> at{ { lists[0].begin(), lists[1].begin() } };
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    auto& next = at[isSecond[r]];
    const auto end = next + static_cast<std::ptrdiff_t>(width * runs[r].Count);
    items.insert(items.end(), next, end);
    next = end;
  }
  return items;
}

/// Returns a message of runs and their items.
Bytes Pack(const std::vector<Run>& runs, const Bytes& items)
{
  if (runs.empty())
  {
    return {};
  }
  Bytes message = ToBytes(std::vector<std::int64_t>{ static_cast<std::int64_t>(runs.size()) });
  const Bytes heads = ToBytes(runs);
  message.reserve(message.size() + heads.size() + items.size());
  message.insert(message.end(), heads.begin(), heads.end());
  message.insert(message.end(), items.begin(), items.end());
  return message;
}

/// Takes the runs from a message (Pack), and leaves their items.
std::vector<Run> TakeRuns(Bytes& message)
{
  if (message.empty())
  {
    return {};
  }
  std::int64_t count;
  std::memcpy(&count, message.data(), sizeof(count));
  const auto begin = message.begin() + sizeof(count);
  const auto end = begin + static_cast<std::ptrdiff_t>(count * sizeof(Run));
  const std::vector<Run> runs = FromBytes<Run>(Bytes(begin, end));
  message.erase(message.begin(), end);
  return runs;
}

bool IsBefore(const Run& a, const Run& b)
{
  return std::tie(a.Source, a.To) < std::tie(b.Source, b.To);
}

/// Merges two lists of runs. Sets whether each run is of the second list.
std::vector<Run> Merge(const std::vector<Run>& first, const std::vector<Run>& second,
  std::vector<unsigned char>& isSecond)
{
  std::vector<Run> merged;
  auto a = first.begin(), b = second.begin();
  while (a != first.end() || b != second.end())
  {
    const bool takesSecond = a == first.end() || (b != second.end() && IsBefore(*b, *a));
    merged.push_back(takesSecond ? *b++ : *a++);
    isSecond.push_back(takesSecond);
  }
  return merged;
}

} // namespace

ItemRoute::ItemRoute(const std::vector<int>& to, Ranks& ranks) :
  Group(&ranks), Order(to.size()), Runs(1)
{
  std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
  if (!std::is_sorted(to.begin(), to.end()))
  {
    std::stable_sort(this->Order.begin(), this->Order.end(),
      [&to](std::size_t a, std::size_t b) { return to[a] < to[b]; });
  }
  for (std::size_t place : this->Order)
  {
    std::vector<Run>& runs = this->Runs[0];
    if (runs.empty() || runs.back().To != to[place])
    {
      runs.push_back({ ranks.Rank(), to[place], 0 });
    }
    ++runs.back().Count;
  }
}

/// Sends some runs to a partner and receives others.
/// @param isSent  isSent(run)
/// @param items  of the last runs; then of those after the stage
template <class IsSent>
void ItemRoute::AddStage(int partner, std::size_t width, const IsSent& isSent, Bytes& items)
{
  const std::vector<Run>& before = this->Runs.back();
  Stage stage{ partner, {}, {} };
  std::array<std::vector<Run>, 2> runs; // kept and sent
  for (const Run& run : before)
  {
    stage.IsSent.push_back(isSent(run));
    runs[stage.IsSent.back()].push_back(run);
  }
  std::array<Bytes, 2> lists = Divide(items, before, stage.IsSent, width);
  lists[1] = std::move(this->Group->Exchange({ partner }, { Pack(runs[1], lists[1]) })[0]);
  runs[1] = TakeRuns(lists[1]);
  std::vector<Run> after = Merge(runs[0], runs[1], stage.IsReceived);
  items = Join(lists, after, stage.IsReceived, width);
  this->Runs.push_back(std::move(after));
  this->Stages.push_back(std::move(stage));
}

// Ranks that are no corners of the hypercube send and receive through one that is. The ranks of all
// items that a rank holds have its high bits as sources, and its low bits as receivers. So no two
// runs of a rank have the same source and receiver.
Bytes ItemRoute::SendBytes(Bytes items, std::size_t width)
{
  const int corners = CountHomes(*this->Group), rank = this->Group->Rank();
  const bool isGuest = rank >= corners;
  const int other = isGuest ? rank - corners : rank + corners;
  const bool hasOther = other < this->Group->Count();
  if (hasOther)
  {
    this->AddStage(
      other, width, [&](const Run& run) { return isGuest ? run.To != rank : run.To == other; },
      items);
  }
  for (int bit = 1; !isGuest && bit < corners; bit *= 2)
  {
    this->AddStage(
      rank ^ bit, width, [&](const Run& run) { return ((run.To ^ rank) & bit) != 0; }, items);
  }
  if (hasOther)
  {
    this->AddStage(
      other, width, [&](const Run& run) { return run.To == other; }, items);
  }
  return items;
}

Bytes ItemRoute::ReturnBytes(Bytes answers, std::size_t width) const
{
  for (std::size_t s = this->Stages.size(); s-- > 0;)
  {
    const Stage& stage = this->Stages[s];
    std::array<Bytes, 2> lists = Divide(answers, this->Runs[s + 1], stage.IsReceived, width);
    lists[1] = std::move(this->Group->Exchange({ stage.Partner }, { std::move(lists[1]) })[0]);
    answers = Join(lists, this->Runs[s], stage.IsSent, width);
  }
  return answers;
}

} // namespace vfm
