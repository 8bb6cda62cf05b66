/**
 * SumOverRange: sums over some of the ranks.
 */
#pragma once

#include "Ranks/Ranks.h"

namespace vfm
{

/// Replaces each value by its sum over the ranks [first, first + count), of which this rank is one.
/// All of them pass the same number of values.
/// @pre Collective over these ranks.  @note About log2(count) messages per rank.
void SumOverRange(int first, int count, std::vector<std::int64_t>& values, Ranks& ranks);

} // namespace vfm
