/**
 * GreatestId: the greatest global id, after which new ids begin.
 */
#pragma once

#include "Base/Buffer.h"
#include "Ranks/Agreement.h"

#include <algorithm>

namespace vfm
{

/// Returns the greatest id of all ranks; 0 without ids.
/// @param first,last  ids of this rank, in any order
/// @pre Collective
inline Index FindGreatestId(const Index* first, const Index* last, Ranks& ranks)
{
  return MaximumOverRanks(first == last ? 0 : *std::max_element(first, last), ranks);
}
inline Index FindGreatestId(const Buffer<Index>& ids, Ranks& ranks)
{
  return FindGreatestId(ids.data(), ids.data() + ids.size(), ranks);
}

} // namespace vfm
