/// Sharp fractions from fields of fractions, and children of mixed cells.
#include "Fractions/SharpFractions.h"
#include "Fractions/ChildFractions.h"
#include "RandomDraw.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns a field that grows along x from `low` to `high`.
MaterialPatch AlongX(int material, double low, double high)
{
  MaterialPatch patch{ material, {} };
  for (int n = 0; n < MaterialPatch::Size; ++n)
  {
    patch.Values[n] = low + (high - low) * 0.5 * (n % MaterialPatch::Row);
  }
  return patch;
}

} // namespace

TEST(SharpFractions, PlaneWhereFieldsAreEqual)
{
  SharpFractions sharp;
  const std::vector<double> two = sharp.Find({ AlongX(1, 0.0, 1.0), AlongX(2, 0.6, 0.0) });
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[0], 1.0 - 0.6 / 1.6, 1e-12);
  EXPECT_NEAR(two[0] + two[1], 1.0, 1e-14);
  const std::vector<double> one{ 1.0, 0.0 };
  EXPECT_EQ(sharp.Find({ AlongX(1, 0.6, 1.0), AlongX(2, 0.5, 0.0) }), one);
}

/// Returns a field with values at random in [low, high].
MaterialPatch AtRandom(int material, double low, double high, RandomDraw& draw)
{
  MaterialPatch patch{ material, {} };
  for (double& value : patch.Values)
  {
    value = draw.Between(low, high);
  }
  return patch;
}

/// Returns the field at a point of the cell, whose sides are 0 and 2.
double ValueAt(const MaterialPatch& patch, const std::array<double, 3>& x)
{
  double value = 0.0;
  for (int n = 0; n < 27; ++n)
  {
    const int at[3] = { n % 3, n / 3 % 3, n / 9 };
    double weight = 1.0;
    for (int a = 0; a < 3; ++a)
    {
      weight *= std::max(0.0, 1.0 - std::fabs(x[a] - at[a]));
    }
    value +=
      weight * patch.Values[at[0] + MaterialPatch::Row * at[1] + MaterialPatch::Layer * at[2]];
  }
  return value;
}

TEST(SharpFractions, SamplesOfManyFields)
{
  RandomDraw draw(5);
  std::vector<MaterialPatch> patches;
  for (int m = 0; m < 6; ++m)
  {
    patches.push_back(AtRandom(m, 0.2, 0.4, draw));
  }
  std::vector<double> expected(patches.size(), 0.0);
  for (int s = 0; s < 512; ++s) // the samples of the eight octants
  {
    const std::array<double, 3> x{ { (s % 8 + 0.5) / 4, (s / 8 % 8 + 0.5) / 4,
      (s / 64 + 0.5) / 4 } };
    const auto isLess = [&](const MaterialPatch& a, const MaterialPatch& b)
    { return ValueAt(a, x) < ValueAt(b, x); };
    expected[std::max_element(patches.begin(), patches.end(), isLess) - patches.begin()] +=
      1.0 / 512;
  }
  const std::vector<double> fractions = SharpFractions().Find(patches);
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    EXPECT_GT(fractions[p], 0.0) << p;
    EXPECT_NEAR(fractions[p], expected[p], 1e-12) << p;
  }
}

TEST(SharpFractions, FieldsBehindALeaderHaveNoPart)
{
  RandomDraw draw(9);
  SharpFractions sharp;
  int left = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    std::vector<MaterialPatch> patches;
    for (int m = 0; m < 3; ++m)
    {
      patches.push_back(AtRandom(m, 0.1, m == 1 ? 1.0 : 0.5, draw));
    }
    patches[1].Values.fill(0.5); // leads a part of the others
    const double lead = FindLead(patches[1], patches[0]), weight = draw.Between(0.5, 2.0);
    std::vector<MaterialPatch> weighted = patches;
    for (double& value : weighted[1].Values)
    {
      value *= weight;
    }
    const std::vector<double> all = sharp.Find(weighted);
    if (lead * weight > 1.0 + 1e-6)
    {
      const std::vector<double> rest = sharp.Find({ weighted[1], weighted[2] });
      EXPECT_EQ(all, (std::vector<double>{ 0.0, rest[0], rest[1] }));
      ++left;
    }
  }
  EXPECT_GT(left, 20);
  EXPECT_LT(left, 180);
  EXPECT_LE(FindLead(AlongX(1, 0.0, 1.0), AlongX(2, 0.0, 0.0)), 0.0);
}

TEST(SharpFractions, ChildrenOnOneSideAreFull)
{
  const MaterialPatch first = AlongX(1, 0.0, 1.0), second = AlongX(2, 1.0, 0.0);
  const std::vector<double> parts = ShareChildren(first, second, { { 4, 1, 1 } }, 0.375);
  const std::vector<double> right{ 0.0, 0.0, 0.5, 1.0 };
  ASSERT_EQ(parts.size(), right.size());
  for (std::size_t c = 0; c < right.size(); ++c)
  {
    EXPECT_NEAR(parts[c], right[c], 1e-9);
  }
}

TEST(ChildFractions, PartsKeepTheirVolumesAndFillChildren)
{
  const CartesianGrid grid = MakeUnevenGrid(6);
  const FractionField field = MakePatchyFractions(grid, 3, 4);
  const Index3 counts{ { 2, 1, 3 } };
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p);
      if (!field.IsMixed(cell))
      {
        return;
      }
      const std::vector<ChildFractions> split = SplitCell(grid, field, p, counts);
      std::vector<double> sums(6, 0.0);
      std::size_t part = 0;
      for (const FractionField::Part& whole : field.Parts(cell))
      {
        const ChildFractions& children = split[part++];
        ASSERT_EQ(children.size(), sums.size());
        ASSERT_NEAR(
          std::accumulate(children.begin(), children.end(), 0.0) / 6.0, whole.Fraction, 1e-12);
        for (std::size_t c = 0; c < children.size(); ++c)
        {
          ASSERT_GE(children[c], 0.0);
          sums[c] += children[c];
        }
      }
      ASSERT_EQ(part, split.size());
      for (double sum : sums)
      {
        ASSERT_NEAR(sum, 1.0, 1e-12);
      }
    });
}
