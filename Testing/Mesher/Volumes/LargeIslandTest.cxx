/// Conjugate gradients for one large island.
#include "Volumes/LargeIsland.h"
#include "Grains.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(LargeIsland, IterationsDoNotGrowWithTheNumberOfGrains)
{
  for (bool hasVoid : { true, false })
  {
    for (int n : { 10, 20, 30 })
    {
      const Grains lattice = MakeLattice(n, hasVoid);
      Ranks alone;
      GrainLevel grains = MakeGrainLevel(lattice, alone);
      std::vector<FragmentPair> pairs = grains.Level.Pairs.Pairs();
      const LargeIsland island(std::move(grains.Level.Share), std::move(pairs), grains.Areas);
      int iterations = 0;
      const std::vector<double> mu = island.Solve(grains.Areas, grains.Lack, &iterations);
      EXPECT_LE(iterations, 13) << lattice.Count << " grains";
      EXPECT_LT(LargestResidual(lattice, mu), 1e-5);
    }
  }
}
