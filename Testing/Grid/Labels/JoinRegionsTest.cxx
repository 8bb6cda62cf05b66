/// Small regions choose the materials of the regions around them, by islands.
#include "Labels/JoinRegions.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

/// Returns the regions of one rank.
FragmentShare MakeShare(const std::vector<int>& materials, Ranks& alone)
{
  FragmentShare share;
  share.Materials = materials;
  share.IsMine.assign(materials.size(), 1);
  share.IsShared.assign(materials.size(), 0);
  for (int r = 1; r < static_cast<int>(materials.size()); ++r)
  {
    share.Ids.push_back(r);
  }
  share.Ways = KeyMerge<Index>({}, alone);
  share.Group = &alone;
  return share;
}

/// Returns the final materials of regions 1, 2, ..
/// @param shared  pairs of regions with their numbers of faces, each pair once
std::vector<int> Join(std::vector<int> materials, std::vector<Index> cells, Index minimum,
  const std::vector<SharedFaces>& shared)
{
  Ranks alone;
  materials.insert(materials.begin(), 0);
  cells.insert(cells.begin(), 0);
  std::vector<SharedFaces> faces;
  for (const SharedFaces& pair : shared)
  {
    for (const SharedFaces& side : { pair, SharedFaces{ pair.Other, pair.Region, pair.Count } })
    {
      if (cells[side.Region] < minimum)
      {
        faces.push_back(side);
      }
    }
  }
  std::vector<int> joined = JoinRegions(MakeShare(materials, alone), cells, minimum, faces, alone);
  joined.erase(joined.begin());
  return joined;
}

} // namespace

TEST(JoinRegions, TakeTheMaterialOfMostFaces)
{
  EXPECT_EQ(
    Join({ 1, 2, 3 }, { 9, 9, 1 }, 2, { { 3, 1, 2 }, { 3, 2, 4 } }), (std::vector<int>{ 1, 2, 2 }));
  // two large regions of one material count together
  EXPECT_EQ(Join({ 1, 1, 2, 3 }, { 9, 9, 9, 1 }, 2, { { 4, 1, 2 }, { 4, 2, 1 }, { 4, 3, 2 } }),
    (std::vector<int>{ 1, 1, 2, 1 }));
  EXPECT_EQ(
    Join({ 2, 1, 3 }, { 9, 9, 1 }, 2, { { 3, 1, 3 }, { 3, 2, 3 } }), (std::vector<int>{ 2, 1, 1 }))
    << "a tie";
}

TEST(JoinRegions, TheSmallestComesFirst)
{
  // Region 3 joins 2. Both are too small, and join 1.
  EXPECT_EQ(
    Join({ 1, 2, 3 }, { 9, 2, 1 }, 4, { { 2, 1, 2 }, { 3, 2, 5 } }), (std::vector<int>{ 1, 1, 1 }));
  // Joined they are large enough.
  EXPECT_EQ(
    Join({ 1, 2, 3 }, { 9, 2, 1 }, 3, { { 2, 1, 2 }, { 3, 2, 5 } }), (std::vector<int>{ 1, 2, 2 }));
}

TEST(JoinRegions, WithoutNeighboursStay)
{
  EXPECT_EQ(Join({ 3 }, { 1 }, 5, {}), std::vector<int>{ 3 });
}
