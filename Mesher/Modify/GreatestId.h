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
/// @param ids in any order
/// @pre Collective
inline Index FindGreatestId(const Buffer<Index>& ids, Ranks& ranks)
{
  return MaximumOverRanks(ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end()), ranks);
}

} // namespace vfm
