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

RisingHomes::RisingHomes(const std::vector<std::int64_t>& values, Ranks& ranks) :
  NumberOfRanges(std::min(64 * CountHomes(ranks), 4096))
{
  // Doubles round, so the range is widened by as much; values outside go to the first or last one.
  constexpr double none = -std::numeric_limits<double>::max();
  std::vector<double> ends{ none, none }; // minus the lowest value, and the highest
  for (std::int64_t value : values)
  {
    ends[0] = std::max(ends[0], -static_cast<double>(value));
    ends[1] = std::max(ends[1], static_cast<double>(value));
  }
  ranks.Max(ends);
  if (ends[0] > none)
  {
    this->Lowest = static_cast<std::int64_t>(-ends[0]);
    while (
      std::ldexp(ends[1] + ends[0] + 1.0, -this->Shift) > static_cast<double>(this->NumberOfRanges))
    {
      ++this->Shift;
    }
  }
  std::vector<std::int64_t> counts(this->NumberOfRanges, 0);
  for (std::int64_t value : values)
  {
    ++counts[this->RangeOf(value)];
  }
  ranks.Sum(counts);
  std::int64_t total = 1, before = 0;
  for (std::int64_t count : counts)
  {
    total += count;
  }
  const auto homes = static_cast<double>(CountHomes(ranks));
  for (std::int64_t count : counts)
  {
    const double middle = (static_cast<double>(before) + 0.5 * static_cast<double>(count));
    this->HomeOfRange.push_back(static_cast<int>(homes * middle / static_cast<double>(total)));
    before += count;
  }
}

std::size_t RisingHomes::RangeOf(std::int64_t value) const
{
  const std::int64_t above = std::max<std::int64_t>(value - this->Lowest, 0) >> this->Shift;
  return static_cast<std::size_t>(std::min(above, this->NumberOfRanges - 1));
}

} // namespace vfm
