/**
 * MatchFragments: pairs of neighbouring fragments with strong coupling, the same on any number of
 * ranks.
 */
#pragma once

#include "Volumes/IslandLevel.h"

namespace vfm
{

/// Matches most fragments with one neighbour each: pairs with a large ratio of their area to the
/// smaller diagonal of both first. Fragments that remain join a neighbour's pair.
/// @return number over all ranks of the group of each fragment or group of this rank, which is that
///   of a member
/// @pre Collective.
std::vector<Index> MatchFragments(const IslandLevel& level, const IslandValues& values);

} // namespace vfm
