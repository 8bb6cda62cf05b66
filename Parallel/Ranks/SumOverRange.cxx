#include "Ranks/SumOverRange.h"

namespace vfm
{

/// Partial sums are exchanged along the edges of a hypercube of ranks. Ranks that are no corners of
/// it add their values to a corner first, and get the sums from it.
void SumOverRange(int first, int count, std::vector<std::int64_t>& values, Ranks& ranks)
{
  using Values = std::vector<std::int64_t>;
  const auto swap = [&](int place, const Values& sent)
  { return FromBytes<std::int64_t>(ranks.Exchange({ first + place }, { ToBytes(sent) })[0]); };
  const auto add = [&values](const Values& received)
  {
    for (std::size_t i = 0; i < received.size(); ++i)
    {
      values[i] += received[i];
    }
  };
  int corners = 1;
  while (corners <= count / 2)
  {
    corners *= 2;
  }
  const int own = ranks.Rank() - first;
  const bool isCorner = own < corners;
  const int partner = isCorner ? own + corners : own - corners;
  if (partner < count)
  {
    add(swap(partner, isCorner ? Values() : values));
  }
  for (int bit = 1; isCorner && bit < corners; bit *= 2)
  {
    add(swap(own ^ bit, values));
  }
  if (partner < count)
  {
    const Values sums = swap(partner, isCorner ? values : Values());
    values = isCorner ? values : sums;
  }
}

} // namespace vfm
