/// Systems of shifts by islands, on ranks that are threads.
#include "Volumes/IslandSystem.h"
#include "Grains.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const int RankCounts[] = { 2, 3, 5, 6, 7, 8, 27 };

/// Expects equal bits on several ranks, and returns the solution.
std::vector<double> SolveOnAllCounts(const Grains& grains)
{
  std::vector<double> one = SolveOnRanks(grains, 1);
  for (int count : RankCounts)
  {
    EXPECT_EQ(SolveOnRanks(grains, count), one) << count << " ranks";
  }
  return one;
}

} // namespace

TEST(IslandSystem, SmallIslandsHaveTheBitsOfTheFactorization)
{
  Grains lattice = MakeLattice(6, true);
  EXPECT_EQ(SolveOnAllCounts(lattice), SolveForLack(lattice.Areas, lattice.Lack));
}
