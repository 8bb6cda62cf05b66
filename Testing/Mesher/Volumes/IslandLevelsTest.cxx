/// The approximate solver of large islands.
#include "Volumes/IslandLevels.h"
#include "Grains.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(IslandLevels, EachCycleReducesTheResidual)
{
  for (bool hasVoid : { true, false })
  {
    const Grains lattice = MakeLattice(17, hasVoid); // three levels
    Ranks alone;
    GrainLevel grains = MakeGrainLevel(lattice, alone);
    const IslandLevels levels(std::move(grains.Level), grains.Areas);
    const IslandLevels::System system = levels.MakeSystem(grains.Areas);
    std::vector<double> rest = grains.Lack;
    for (int cycle = 0; cycle < 8; ++cycle)
    {
      const std::vector<double> x = levels.Approximate(system, rest);
      EXPECT_GT(Dot(levels.First().Share, x, rest), 0.0) << "positive definite";
      AddTimes(-1.0, Multiply(levels.First(), system.Values[0], x), rest);
    }
    const FragmentShare& share = levels.First().Share;
    EXPECT_LT(Dot(share, rest, rest), 1e-4 * Dot(share, grains.Lack, grains.Lack));
  }
}
