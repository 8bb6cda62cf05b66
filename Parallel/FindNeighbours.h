/**
 * FindNeighbours: the ranks whose boxes touch this rank's box, over faces, edges and corners, from the face neighbours
 * alone. For host codes that know no more than that.
 */
#pragma once

#include "CartesianGrid.h"
#include "Ranks.h"

namespace vfm
{

/// A rank and its bounding box (length units of the user).
struct RankBox
{
  int Rank;
  Vector3 Lower, Upper;
};

/// Collective. faces: the ranks across -x +x -y +y -z +z, or -1; rank j must name i where i names j.
/// Every rank sends its box to its face neighbours, then in two hops the boxes that it knows, merges what it receives,
/// and drops the boxes that do not touch its own (SAND report 2010, section 2.9). So each rank talks to at most six
/// others, and memory does not grow with the ranks.
/// Result: ascending by rank, this rank left out. Throws InputError on all ranks when a face neighbour is no rank,
/// does not name this rank, or its box does not touch.
std::vector<RankBox> FindNeighbours(
  const RankBox& mine, const std::array<int, 6>& faces, Ranks& ranks);

} // namespace vfm
