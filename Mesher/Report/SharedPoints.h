/**
 * SharedPoints: finds the points of a mesh that are also on other ranks.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Ranks/Ranks.h"

#include <map>
#include <vector>

namespace vfm
{

struct SharedPoints
{
  /// Common points with each other rank, as indices in ids, ordered by id. The list of the other
  /// rank has the same points in the same order.
  std::map<int, std::vector<Index>> Places;
  std::vector<char> IsOwned; ///< each point: 1 if no lower rank has it
};

/// Finds the points that this rank shares with other ranks.
/// @param ids global ids >= 0 of this rank's points, each once
/// @pre Collective
/// @note An id determines the rank that compares it, so each rank sends and receives about as many
/// ids as it has points.
SharedPoints FindSharedPoints(const std::vector<Index>& ids, Ranks& ranks);

} // namespace vfm
