/**
 * Sums and lists that are equal on all ranks; includes WorkTogether for common errors.
 */
#pragma once

#include "Ranks/WorkTogether.h"

#include <algorithm>
#include <limits>

namespace vfm
{

/// Returns the sum of a number over all ranks.
/// @pre Collective over `ranks`.
inline std::int64_t SumOverRanks(std::int64_t mine, Ranks& ranks)
{
  std::vector<std::int64_t> sum{ mine };
  ranks.Sum(sum);
  return sum[0];
}

/// Returns the values that at least one rank holds, ascending and without duplicates.
/// @param most  maximum number of values to return: the lowest ones
/// @pre Collective over `ranks`.
/// @note Lists are merged up a binary tree and sent down again. A rank of P sends at most
///   2 log2 P messages.
template <class T>
std::vector<T> UnionOverRanks(
  Ranks& ranks, std::vector<T> values, std::size_t most = std::numeric_limits<std::size_t>::max())
{
  const auto tidy = [&values, most]
  {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    values.erase(
      values.begin() + static_cast<std::ptrdiff_t>(std::min(most, values.size())), values.end());
  };
  tidy();
  const int rank = ranks.Rank();
  int step = 1;
  for (; step < ranks.Count() && rank % (2 * step) == 0; step *= 2)
  {
    if (rank + step < ranks.Count())
    {
      const std::vector<T> more = FromBytes<T>(ranks.Exchange({ rank + step }, { Bytes() })[0]);
      values.insert(values.end(), more.begin(), more.end());
      tidy();
    }
  }
  if (rank > 0) // step is the lowest set bit of the rank
  {
    ranks.Exchange({ rank - step }, { ToBytes(values) });
    values = FromBytes<T>(ranks.Exchange({ rank - step }, { Bytes() })[0]);
  }
  for (step /= 2; step > 0; step /= 2)
  {
    if (rank + step < ranks.Count())
    {
      ranks.Exchange({ rank + step }, { ToBytes(values) });
    }
  }
  return values;
}

/// Returns the maximum of an integer over all ranks, exact above 2^53.
/// @pre Collective over `ranks`.
inline std::int64_t MaximumOverRanks(std::int64_t mine, Ranks& ranks)
{
  return ~UnionOverRanks(ranks, std::vector<std::int64_t>{ ~mine }, 1)[0]; // ~ reverses the order
}

} // namespace vfm
