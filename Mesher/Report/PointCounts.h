/**
 * PointCounts: counts the distinct points of parts of a mesh over all ranks.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Counts the points of each part by GlobalPointIds.
/// @param partOf part of each element, from 0
/// @pre Collective
/// @note Each rank counts a share of the ids, so it sends and receives about as many ids as it
/// has points.
std::vector<Index> CountPoints(
  const MeshData& mesh, const std::vector<int>& partOf, std::size_t numberOfParts, Ranks& ranks);

} // namespace vfm
