/// The system of a level, factored on one rank.
#include "Volumes/CoarsestLevel.h"
#include "Grains.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(CoarsestLevel, AllRanksGetTheSolution)
{
  const Grains lattice = MakeLattice(5, true);
  const std::vector<double> expected = SolveForLack(lattice.Areas, lattice.Lack);
  std::vector<double> first;
  for (int count : { 1, 3, 5, 8 })
  {
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const GrainLevel grains = MakeGrainLevel(lattice, ranks);
        const CoarsestLevel coarsest(grains.Level);
        const auto factors = coarsest.Factor(grains.Level, MakeValues(grains.Level, grains.Areas));
        const std::vector<double> mu =
          GatherValues(grains.Level.Share, coarsest.Solve(*factors, grains.Lack));
        for (int f = 1; f <= lattice.Count; ++f)
        {
          EXPECT_NEAR(mu[f], expected[f], 1e-14);
        }
        if (ranks.Rank() == 0)
        {
          first = count == 1 ? mu : first;
          EXPECT_EQ(mu, first);
        }
      });
  }
}
