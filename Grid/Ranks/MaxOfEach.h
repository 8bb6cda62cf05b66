/**
 * The largest of each of some values over all ranks.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <algorithm>
#include <vector>

namespace vfm
{

/// Collective: in place.
inline void MaxOfEach(std::vector<double>& values, Ranks& ranks)
{
  for (const Bytes& bytes : ranks.Gather(ToBytes(values)))
  {
    const std::vector<double> others = FromBytes<double>(bytes);
    std::transform(others.begin(), others.end(), values.begin(), values.begin(),
      [](double a, double b) { return std::max(a, b); });
  }
}

} // namespace vfm
