/**
 * MaxOfEach: maxima over all ranks.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <algorithm>
#include <vector>

namespace vfm
{

/// Replaces each value by its maximum over all ranks.
/// @pre Collective over `ranks`; the same number of values on each rank.
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
