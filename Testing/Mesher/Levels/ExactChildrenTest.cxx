/// Fractions of half cells from surfaces, against the exact fractions on the fine grid.
#include "Levels/ExactChildren.h"

#include "../GivenSurfaces/GivenCases.h"
#include "Base/ThreadRuntime.h"
#include "Fractions/RefineCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// An oblique box and a ball next to it: where bodies overlap, fractions depend on the cells.
std::vector<ClosedSurface> BoxAndBall()
{
  const Vector3 centre{ { 6.1, 6.2, 5.9 } }, half{ { 3, 2, 0.6 } }, angles{ { 20, 30, 40 } };
  return { Turned(BoxSurface(centre - half, centre + half), centre, angles),
    Turned(SphereSurface(centre + Vector3{ { 0.3, 0.2, 2.45 } }, 1.8, 24), centre, angles) };
}

RefinedCells Halve(const GivenCase& c, const FractionField& fractions, Runtime& runtime)
{
  const ExactChildren exact(c.Surfaces, c.Grid, c.Grid, fractions, runtime);
  return RefineCells(c.Grid, fractions, runtime, ChildRule::Planes, {},
    [&exact](const Index3& cell) { return exact.Find(cell); });
}

/// Returns the largest difference of fractions in cells.
double LargestDifference(
  const CartesianGrid& grid, const FractionField& a, const FractionField& b, const IndexBox& cells)
{
  double largest = 0.0;
  ForCells(cells,
    [&](const Index3& p)
    {
      for (int m = 0; m <= a.NumberOfMaterials(); ++m)
      {
        const Index cell = grid.Linear(p);
        largest = std::max(largest, std::fabs(a.Fraction(cell, m) - b.Fraction(cell, m)));
      }
    });
  return largest;
}

} // namespace

TEST(ExactChildren, AreTheFractionsOfTheFineGrid)
{
  GivenCase c(12, BoxAndBall());
  const RefinedCells fine = Halve(c, c.Fractions, c.Run);
  const FractionField truth = FractionsOfBodies(fine.Grid, c.Bodies);
  EXPECT_LT(LargestDifference(fine.Grid, fine.Fractions, truth, fine.Grid.Owned()), 1e-8);
  const RefinedCells planes = RefineCells(c.Grid, c.Fractions, c.Run);
  EXPECT_GT(LargestDifference(fine.Grid, planes.Fractions, truth, fine.Grid.Owned()), 0.1);

  const ExactChildren finer(c.Surfaces, c.Grid, fine.Grid, fine.Fractions, c.Run);
  const RefinedCells finest = RefineCells(fine.Grid, fine.Fractions, c.Run, ChildRule::Planes, {},
    [&finer](const Index3& cell) { return finer.Find(cell); });
  EXPECT_LT(LargestDifference(finest.Grid, finest.Fractions,
              FractionsOfBodies(finest.Grid, c.Bodies), finest.Grid.Owned()),
    1e-8);
}

TEST(ExactChildren, ChangedFractionsKeepTheirPlanes)
{
  GivenCase c(12, BoxAndBall());
  Index3 mixed{};
  ForCells(c.Grid.Owned(),
    [&](const Index3& p) { mixed = c.Fractions.IsMixed(c.Grid.Linear(p)) ? p : mixed; });
  ASSERT_TRUE(c.Fractions.IsMixed(c.Grid.Linear(mixed)));
  EXPECT_FALSE(ExactChildren(c.Surfaces, c.Grid, c.Grid, c.Fractions, c.Run).Find(mixed).empty());
  c.Fractions.SetParts(c.Grid.Linear(mixed), { { 2, 0.37 } });
  const ExactChildren exact(c.Surfaces, c.Grid, c.Grid, c.Fractions, c.Run);
  EXPECT_TRUE(exact.Find(mixed).empty());
}

TEST(ExactChildren, ThreadsChangeNothing)
{
  GivenCase c(12, BoxAndBall());
  const RefinedCells fine = Halve(c, c.Fractions, c.Run);
  ThreadRuntime threads(3);
  const RefinedCells made = Halve(c, c.Fractions, threads);
  EXPECT_EQ(LargestDifference(fine.Grid, fine.Fractions, made.Fractions, fine.Grid.Owned()), 0.0);
}
