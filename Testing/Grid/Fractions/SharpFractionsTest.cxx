/// Sharp fractions from fields of fractions, and children of mixed cells.
#include "Fractions/SharpFractions.h"
#include "Fractions/ChildFractions.h"
#include "RankFields.h"

#include <gtest/gtest.h>

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
