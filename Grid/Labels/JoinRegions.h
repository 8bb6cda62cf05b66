/**
 * JoinRegions: chooses the materials of small regions from the regions around them.
 *
 * Small regions that touch each other, directly or through others, form an island. Regions that are
 * not small keep their materials, so islands do not depend on each other. An island of one rank is
 * decided there, an island of several ranks on one of all ranks, its home.
 */
#pragma once

#include "Labels/FragmentShare.h"

namespace vfm
{

/// Number of faces that a small region shares with another, as this rank sees them. Regions are
/// numbered as on this rank.
struct SharedFaces
{
  int Region, Other;
  Index Count;
};

/// Returns the final material of each region of this rank; [0] is unused. The smallest region comes
/// first, on a tie the region with the lowest cell. It gets the material with which it shares the
/// most faces, on a tie the smaller number, and is united with the regions of that material that it
/// touches. This is repeated while the union is too small. A region that touches no other stays.
/// @param regions  regions by their lowest cells
/// @param cells  number of cells of each region on all ranks
/// @param minimumCells  regions with fewer cells are small
/// @param shared  faces of small regions at cells of this rank, each pair of regions once
/// @pre Collective.
std::vector<int> JoinRegions(const FragmentShare& regions, const std::vector<Index>& cells,
  Index minimumCells, const std::vector<SharedFaces>& shared, Ranks& ranks);

} // namespace vfm
