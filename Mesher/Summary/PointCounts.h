/**
 * PointCounts: how many different points the parts of a mesh on several ranks have.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

namespace vfm
{

/// Collective. partOf: the part of each element, from 0. The points of each part, known by GlobalPointIds; each rank counts
/// those with its share of the ids, so a rank sends and receives no more than it has.
std::vector<Index> CountPoints(
  const MeshData& mesh, const std::vector<int>& partOf, std::size_t numberOfParts, Ranks& ranks);

} // namespace vfm
