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
/// @note Each rank counts a share of the ids.
std::vector<Index> CountPoints(
  const MeshData& mesh, const std::vector<int>& partOf, std::size_t numberOfParts, Ranks& ranks);

/// Numbers of points of some fragments.
struct PointsOfFragments
{
  std::vector<int> Fragments; ///< ids, ascending
  std::vector<Index> Counts;
};

/// Counts the points of each fragment by GlobalPointIds. A fragment may be in the results of
/// several ranks: its points are those of all of them.
/// @param mesh with Fragment
/// @pre Collective
PointsOfFragments CountFragmentPoints(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
