/**
 * SharedPoints: which points of a mesh are on other ranks too.
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
  /// By rank: the places in ids of the points that this rank and that one have, in the order of their ids: the same points in
  /// the same order as that rank's list of this one.
  std::map<int, std::vector<Index>> Places;
  std::vector<char> IsOwned; ///< of each point: no lower rank has it
};

/// Collective. ids: of this rank's points, >= 0, each once; they meet on the rank that the id tells, so that a rank sends and
/// receives about as many as it has.
SharedPoints FindSharedPoints(const std::vector<Index>& ids, Ranks& ranks);

} // namespace vfm
