#include "Ranks/NumberKeys.h"

namespace vfm
{

std::vector<std::int64_t> SumOfLowerRanks(const std::vector<std::int64_t>& mine, Ranks& ranks)
{
  std::vector<std::int64_t> below(mine.size(), 0);
  std::vector<std::int64_t> all = mine; // of the last `step` ranks up to this one
  for (int step = 1; step < ranks.Count(); step *= 2)
  {
    std::vector<int> peers;
    std::vector<Bytes> messages;
    const int from = ranks.Rank() - step, to = ranks.Rank() + step;
    if (from >= 0)
    {
      peers.push_back(from);
      messages.emplace_back();
    }
    if (to < ranks.Count())
    {
      peers.push_back(to);
      messages.push_back(ToBytes(all));
    }
    const std::vector<Bytes> received = ranks.Exchange(peers, messages);
    const auto more = FromBytes<std::int64_t>(from >= 0 ? received[0] : Bytes());
    for (std::size_t i = 0; i < more.size(); ++i)
    {
      below[i] += more[i];
      all[i] += more[i];
    }
  }
  return below;
}

std::pair<std::int64_t, std::int64_t> CountLowerAndAll(std::int64_t count, Ranks& ranks)
{
  std::vector<std::int64_t> total{ count };
  ranks.Sum(total);
  return { SumOfLowerRanks(count, ranks), total[0] };
}

RisingHomes::RisingHomes(const std::vector<std::int64_t>& values, Ranks& ranks) :
  NumberOfRanges(std::min(64 * CountHomes(ranks), 4096))
{
  // Doubles round, so the range is widened by as much.
  constexpr double none = -std::numeric_limits<double>::max();
  std::vector<double> ends{ none, none }; // minus the lowest value, and the highest
  for (std::int64_t value : values)
  {
    ends[0] = std::max(ends[0], -static_cast<double>(value));
    ends[1] = std::max(ends[1], static_cast<double>(value));
  }
  ranks.Max(ends);
  std::int64_t lowest = 0;
  int shift = 0;
  if (ends[0] > none)
  {
    lowest = static_cast<std::int64_t>(-ends[0]);
    while (std::ldexp(ends[1] + ends[0] + 1.0, -shift) > static_cast<double>(this->NumberOfRanges))
    {
      ++shift;
    }
  }
  AddRanges(lowest, shift, this->NumberOfRanges, this->Ranges);
  this->Count(values, ranks);
  std::int64_t total = 0;
  for (const Range& range : this->Ranges)
  {
    total += range.Count;
  }
  const std::int64_t homes = CountHomes(ranks);
  constexpr std::int64_t few = 1024; // values of a home that need no division
  while (this->Divide(std::max(few, 2 * total / homes)))
  {
    this->Count(values, ranks);
  }
  std::int64_t before = 0;
  for (const Range& range : this->Ranges)
  {
    const double middle = static_cast<double>(before) + 0.5 * static_cast<double>(range.Count);
    this->HomeOfRange.push_back(
      static_cast<int>(static_cast<double>(homes) * middle / static_cast<double>(total + 1)));
    before += range.Count;
  }
}

/// Adds ranges of 2^shift values from a value on; fewer if 64 bits cannot hold it.
void RisingHomes::AddRanges(
  std::int64_t start, int shift, std::size_t count, std::vector<Range>& ranges)
{
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  for (std::size_t r = 0; r < count; ++r)
  {
    const std::int64_t above = static_cast<std::int64_t>(r) << shift;
    if (start > 0 && above > largest - start)
    {
      return;
    }
    ranges.push_back({ start + above, shift, -1 });
  }
}

std::size_t RisingHomes::RangeOf(std::int64_t value) const
{
  const auto above = std::upper_bound(this->Ranges.begin() + 1, this->Ranges.end(), value,
    [](std::int64_t v, const Range& range) { return v < range.Start; });
  return static_cast<std::size_t>(above - this->Ranges.begin()) - 1;
}

/// Counts the values in the ranges that have not been counted.
/// @pre Collective.
void RisingHomes::Count(const std::vector<std::int64_t>& values, Ranks& ranks)
{
  std::vector<std::size_t> places(this->Ranges.size()); // of ranges in the counts
  std::vector<std::int64_t> counts;
  for (std::size_t r = 0; r < this->Ranges.size(); ++r)
  {
    places[r] = counts.size();
    counts.resize(counts.size() + (this->Ranges[r].Count < 0 ? 1 : 0), 0);
  }
  for (std::int64_t value : values)
  {
    const std::size_t range = this->RangeOf(value);
    if (this->Ranges[range].Count < 0)
    {
      ++counts[places[range]];
    }
  }
  ranks.Sum(counts);
  for (std::size_t r = 0; r < this->Ranges.size(); ++r)
  {
    if (this->Ranges[r].Count < 0)
    {
      this->Ranges[r].Count = counts[places[r]];
    }
  }
}

/// Divides ranges with more than `most` values into NumberOfRanges parts in all, not yet counted.
/// Returns whether there are any.
bool RisingHomes::Divide(std::int64_t most)
{
  const auto isDivided = [most](const Range& range)
  { return range.Count > most && range.Shift > 0; };
  const auto divided =
    static_cast<std::size_t>(std::count_if(this->Ranges.begin(), this->Ranges.end(), isDivided));
  int halvings = 0;
  while (divided > 0 && divided << (halvings + 1) <= this->NumberOfRanges)
  {
    ++halvings;
  }
  if (halvings == 0)
  {
    return false;
  }
  std::vector<Range> ranges;
  for (const Range& range : this->Ranges)
  {
    if (isDivided(range))
    {
      const int steps = std::min(halvings, range.Shift);
      AddRanges(range.Start, range.Shift - steps, std::size_t(1) << steps, ranges);
    }
    else
    {
      ranges.push_back(range);
    }
  }
  this->Ranges = std::move(ranges);
  return true;
}

} // namespace vfm
