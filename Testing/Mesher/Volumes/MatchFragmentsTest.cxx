/// Matches of grains.
#include "Volumes/MatchFragments.h"
#include "Grains.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns the group of each grain.
std::vector<double> GroupOnRanks(const Grains& grains, int count)
{
  std::vector<double> groups;
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const GrainLevel level = MakeGrainLevel(grains, ranks);
      const std::vector<Index> own =
        MatchFragments(level.Level, MakeValues(level.Level, level.Areas));
      const std::vector<double> all =
        GatherValues(level.Level.Share, std::vector<double>(own.begin(), own.end()));
      if (ranks.Rank() == 0)
      {
        groups = all;
      }
    });
  return groups;
}

} // namespace

TEST(MatchFragments, GroupsAreSmallAndEqualOnAllRanks)
{
  const Grains lattice = MakeLattice(7, true);
  const std::vector<double> groups = GroupOnRanks(lattice, 1);
  std::map<double, int> sizes;
  for (int f = 1; f <= lattice.Count; ++f)
  {
    ++sizes[groups[f]];
    EXPECT_EQ(groups[static_cast<int>(groups[f])], groups[f]) << "it has the number of a member";
  }
  EXPECT_LT(static_cast<int>(sizes.size()), lattice.Count * 6 / 10);
  for (const auto& size : sizes)
  {
    EXPECT_GE(size.second, 2);
    EXPECT_LE(size.second, 6);
  }
  for (int count : { 2, 3, 7, 8, 27 })
  {
    EXPECT_EQ(GroupOnRanks(lattice, count), groups);
  }
}

TEST(MatchFragments, LargeAreasJoinFirst)
{
  Grains ring; // 1 - 2 = 3 - 4 = 5 - 6 = 1, with large areas =
  ring.Count = 6;
  for (int f = 1; f <= 6; ++f)
  {
    ring.Add(f, f % 6 + 1, f % 2 == 0 ? 50.0 : 1.0);
  }
  ring.DrawLacks(1);
  ring.Home = [](int f, int ranks) { return (f - 1) * ranks / 6; };
  const std::vector<double> groups = GroupOnRanks(ring, 2);
  EXPECT_EQ(groups, (std::vector<double>{ 0, 1, 2, 2, 4, 4, 1 }));
}
