/**
 * MatchFaces: what lies behind the faces of elements, also where that is on another rank.
 */
#pragma once

#include "Mesh/ElementFaces.h"
#include "Mesh/MeshFacet.h"
#include "Ranks/Ranks.h"

#include <vector>

namespace vfm
{

/// Collective. ids: of the points of each face, global. values: >= 0, of the element to which each face belongs (its material, its fragment). Returns, for each
/// face, the value of the element on its other side on any rank, or NothingBehind. Throws InputError, on all ranks alike, when a
/// face belongs to more than two elements of one rank, or has no partner on each of three ranks.
std::vector<int> MatchFaces(
  const std::vector<FaceIds>& ids, const std::vector<int>& values, Ranks& ranks);

} // namespace vfm
