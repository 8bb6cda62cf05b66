/// Levels of groups of grains.
#include "Volumes/IslandLevel.h"
#include "Grains.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

// A group of two neighbours along x, and a shift of groups: its effect on the grains, summed by
// group, is that of the system of groups.
TEST(IslandLevel, SystemsOfGroupsAgreeWithThatOfGrains)
{
  const Grains lattice = MakeLattice(4, true);
  std::vector<std::vector<double>> results;
  for (int count : { 1, 2, 8 })
  {
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        GrainLevel grains = MakeGrainLevel(lattice, ranks);
        IslandLevel& level = grains.Level;
        std::vector<Index> groups(1, 0);
        for (std::size_t f = 1; f < level.Share.Size(); ++f)
        {
          groups.push_back((level.Share.Ids[f] - 1) / 2 * 2 + 1);
        }
        const IslandLevel next = MakeNextLevel(level, groups);
        const IslandValues values = MakeValues(level, grains.Areas),
                           nextValues = SumValues(level, values, next);
        std::vector<double> shifts(1, 0.0), ofGrains(1, 0.0);
        for (std::size_t g = 1; g < next.Share.Size(); ++g)
        {
          EXPECT_EQ(next.Share.Ids[g] % 2, 1);
          EXPECT_NEAR(next.Regular[g], 2.0 * RegularDiagonal, 1e-20);
          shifts.push_back(0.01 * (next.Share.Ids[g] * 37 % 64));
        }
        for (std::size_t f = 1; f < level.Share.Size(); ++f)
        {
          ofGrains.push_back(shifts[level.GroupOf[f]]);
        }
        const std::vector<double> fromGrains =
          SumByGroup(level, next, Multiply(level, values, ofGrains));
        const std::vector<double> fromGroups = Multiply(next, nextValues, shifts);
        for (std::size_t g = 1; g < next.Share.Size(); ++g)
        {
          EXPECT_NEAR(fromGroups[g], fromGrains[g], 1e-11);
        }
        std::vector<double> dots{ Dot(next.Share, shifts, fromGroups) };
        AddTimes(0.1, fromGroups, shifts);
        dots.push_back(Dot(next.Share, shifts, nextValues.Diagonal));
        if (ranks.Rank() == 0)
        {
          results.push_back(dots);
        }
      });
  }
  EXPECT_GT(results[0][0], 0.0);
  EXPECT_EQ(results[1], results[0]);
  EXPECT_EQ(results[2], results[0]);
}
