/// Systems of shifts by islands, on ranks that are threads.
#include "Volumes/IslandSystem.h"
#include "Grains.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

// All islands of several grains are solved by conjugate gradients, at homes or together.
constexpr IslandBounds Homes{ 1, 1000000 }, Together{ 1, 1 };

/// Expects equal bits on several ranks.
void ExpectEqualBits(
  const Grains& grains, const std::vector<double>& expected, const IslandBounds& bounds = {})
{
  for (int count : { 2, 3, 5, 6, 7, 27 })
  {
    EXPECT_EQ(SolveOnRanks(grains, count, bounds), expected) << count << " ranks";
  }
}

/// Returns grains whose areas and lacks are multiplied.
Grains Scaled(Grains grains, double areas, double lacks)
{
  for (PairSum& area : grains.Areas)
  {
    const double value = areas * area.Value.Value();
    area.Value = {};
    area.Value.Add(value);
  }
  for (double& lack : grains.Lack)
  {
    lack *= lacks;
  }
  return grains;
}

/// Returns the largest difference of two shifts of neighbours from those of other solutions.
double LargestDifference(
  const Grains& grains, const std::vector<double>& mu, const std::vector<double>& other)
{
  double largest = 0.0;
  for (const PairSum& area : grains.Areas)
  {
    const double shift = mu[area.First] - mu[area.Second],
                 expected = other[area.First] - other[area.Second];
    largest = std::max(largest, std::fabs(shift - expected));
  }
  return largest;
}

} // namespace

TEST(IslandSystem, SmallIslandsHaveTheBitsOfTheFactorization)
{
  const Grains lattice = MakeLattice(6, true);
  const std::vector<double> expected = SolveForLack(lattice.Areas, lattice.Lack);
  EXPECT_EQ(SolveOnRanks(lattice, 1), expected);
  ExpectEqualBits(lattice, expected);
}

TEST(IslandSystem, SingleGrainsHaveTheBitsOfTheFactorization)
{
  Grains drops;
  drops.Count = 60;
  RandomDraw random(4);
  for (int f = 1; f <= drops.Count; ++f)
  {
    if (f % 5 > 0) // some without facets
    {
      drops.Add(0, f, random.Scale(1e-12, 1e6));
    }
  }
  drops.DrawLacks(1);
  drops.Lack[7] = 0.0;
  drops.Home = [](int f, int ranks) { return f * 7 % ranks; };
  const std::vector<double> expected = SolveForLack(drops.Areas, drops.Lack);
  EXPECT_EQ(SolveOnRanks(drops, 1), expected);
  EXPECT_EQ(SolveOnRanks(drops, 1)[7], 0.0);
  ExpectEqualBits(drops, expected);
}

TEST(IslandSystem, EachIslandIsSolvedByItself)
{
  const Grains parts[] = { MakeLattice(3, true, 1), MakeLattice(2, false, 2),
    MakeLattice(4, true, 3), MakeLattice(1, true, 4), MakeLattice(3, false, 5) };
  Grains all = parts[0];
  std::vector<double> expected = SolveForLack(all.Areas, all.Lack);
  for (int i = 1; i < 5; ++i)
  {
    all.Append(parts[i]);
    const std::vector<double> own = SolveForLack(parts[i].Areas, parts[i].Lack);
    expected.insert(expected.end(), own.begin() + 1, own.end());
  }
  EXPECT_EQ(SolveOnRanks(all, 1), expected);
  ExpectEqualBits(all, expected);
}

TEST(IslandSystem, AllMethodsGiveTheSolution)
{
  for (bool hasVoid : { true, false })
  {
    const Grains lattice = MakeLattice(11, hasVoid);
    const std::vector<double> exact = SolveForLack(lattice.Areas, lattice.Lack);
    const std::vector<double> mu = SolveOnRanks(lattice, 1, Homes);
    EXPECT_LT(LargestResidual(lattice, mu), 1e-5);
    EXPECT_LT(LargestDifference(lattice, mu, exact), 1e-6); // of shifts up to 1e-2
    EXPECT_EQ(SolveOnRanks(lattice, 8, Homes), mu);
    ExpectEqualBits(lattice, mu, Together);
  }
}

TEST(IslandSystem, ManyLevelsHaveEqualBits)
{
  const Grains lattice = MakeLattice(17, false); // 4,913 grains, about 550 groups, 60 groups
  const std::vector<double> mu = SolveOnRanks(lattice, 1);
  EXPECT_LT(LargestResidual(lattice, mu), 1e-5);
  EXPECT_EQ(SolveOnRanks(lattice, 3), mu); // at a home
  EXPECT_EQ(SolveOnRanks(lattice, 6, Together), mu);
}

TEST(IslandSystem, SeveralLargeIslandsDoNotDependOnEachOther)
{
  const Grains first = MakeLattice(9, true, 3), second = MakeLattice(9, false, 4);
  std::vector<double> expected = SolveOnRanks(first, 1, Together);
  const std::vector<double> own = SolveOnRanks(second, 1, Together);
  expected.insert(expected.end(), own.begin() + 1, own.end());
  Grains both = first;
  both.Append(second);
  EXPECT_EQ(SolveOnRanks(both, 1, Together), expected);
  EXPECT_EQ(SolveOnRanks(both, 5, Together), expected);
  EXPECT_EQ(SolveOnRanks(both, 8, Homes), expected);
}

TEST(IslandSystem, WithoutLackNothingShifts)
{
  const Grains lattice = Scaled(MakeLattice(9, true), 1.0, 0.0);
  const std::vector<double> zero(lattice.Count + 1, 0.0);
  EXPECT_EQ(SolveOnRanks(lattice, 1), zero);
  EXPECT_EQ(SolveOnRanks(lattice, 3, Together), zero);
}

TEST(IslandSystem, AnIslandWithoutVoidMayLackVolume)
{
  // All grains gain: only the small diagonal limits the shift that they have in common.
  Grains lattice = MakeLattice(9, false);
  lattice.Lack.assign(lattice.Lack.size(), 1e-3);
  for (double mu : SolveOnRanks(lattice, 2, Together))
  {
    EXPECT_TRUE(mu == 0.0 || std::fabs(mu - 1e3) < 1.0) << mu;
  }
  lattice.DrawLacks(8);
  const std::vector<double> exact = SolveForLack(lattice.Areas, lattice.Lack);
  EXPECT_LT(LargestDifference(lattice, SolveOnRanks(lattice, 2, Together), exact), 1e-6);
}

TEST(IslandSystem, ScalesOfAreasAndLacksDoNotMatter)
{
  const Grains lattice = MakeLattice(9, true);
  for (double areas : { 0x1p-40, 0x1p14 })
  {
    const double lacks = 0x1p-20;
    const Grains scaled = Scaled(lattice, areas, lacks);
    const std::vector<double> mu = SolveOnRanks(scaled, 3, Together);
    EXPECT_LT(LargestResidual(scaled, mu), 1e-5 * lacks);
  }
}

TEST(IslandSystem, AreasOfManyMagnitudes)
{
  Grains lattice = MakeLattice(10, true);
  RandomDraw random(12);
  for (PairSum& area : lattice.Areas)
  {
    area.Value = {};
    area.Value.Add(random.Scale(1e-12, 1e6));
  }
  const std::vector<double> mu = SolveOnRanks(lattice, 1, Together);
  const double factored = LargestResidual(lattice, SolveForLack(lattice.Areas, lattice.Lack));
  EXPECT_LT(LargestResidual(lattice, mu), 1e-5 + 10.0 * factored);
  EXPECT_EQ(SolveOnRanks(lattice, 6, Together), mu);
}
