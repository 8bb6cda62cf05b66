/**
 * FindNeighbours: the ranks whose boxes touch this rank's box, over faces, edges and corners, or lie within some reach of
 * it, from the face neighbours alone. For host codes that know no more than that.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// A rank and its bounding box, in lengths or in cells.
struct RankBox
{
  int Rank;
  Vector3 Lower, Upper;
};

/// Collective. faces: the ranks across -x +x -y +y -z +z, or -1; rank j must name i where i names j.
/// reach: how far off a box still counts, the same on all ranks; 0: it must touch.
/// Every rank sends its box to its face neighbours, then in two hops the boxes that it knows, merges what it receives,
/// and drops the boxes out of its reach (SAND report 2010, section 2.9); where boxes are thinner than the reach it takes
/// more hops. So each rank talks to at most six others, and memory does not grow with the ranks.
/// Result: ascending by rank, this rank left out. Throws InputError on all ranks when a face neighbour is no rank,
/// does not name this rank, or its box does not touch.
std::vector<RankBox> FindNeighbours(
  const RankBox& mine, const std::array<int, 6>& faces, Ranks& ranks, double reach = 0.0);

} // namespace vfm
