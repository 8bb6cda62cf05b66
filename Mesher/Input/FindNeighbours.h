/**
 * FindNeighbours: finds the ranks whose boxes touch this rank's box (faces, edges, corners) or lie
 * within a given distance, for host codes that only know the face neighbours.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// A rank and its bounding box, in length units or in cells.
struct RankBox
{
  int Rank;
  Vector3 Lower, Upper;
};

/// Finds the ranks whose boxes are near.
/// Each rank sends its box to its face neighbours. In two more hops it sends the boxes that it
/// knows, merges the received boxes, and drops those out of reach (SAND report 2010, section 2.9).
/// Boxes thinner than the reach need more hops.
/// @param faces ranks across -x +x -y +y -z +z, or -1; if i names j, j must name i
/// @param reach maximum distance of a near box, equal on all ranks; 0: the boxes touch
/// @return near ranks except this one, ascending by rank
/// @throws InputError if a face neighbour is not a rank, does not name this rank, or its box does
/// not touch; on all ranks
/// @pre Collective
/// @note Each rank exchanges messages with at most six others; memory does not grow with the number
/// of ranks.
std::vector<RankBox> FindNeighbours(
  const RankBox& mine, const std::array<int, 6>& faces, Ranks& ranks, double reach = 0.0);

} // namespace vfm
