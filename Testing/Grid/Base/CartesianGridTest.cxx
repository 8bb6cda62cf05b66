/// Indices, keys and colours of grids, with and without periods.
#include "Base/CartesianGrid.h"
#include "Base/GlobalIds.h"
#include "Base/Runtime.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

const std::array<std::vector<double>, 3> Lists{ { { 0.0, 1.0, 3.0, 4.0 },
  { -1.0, 0.0, 2.0, 3.0, 3.5 }, { 5.0, 6.0, 7.0, 9.0, 10.0, 11.0 } } };

} // namespace

TEST(CartesianGrid, LinearIndicesAgreeWithPositions)
{
  const CartesianGrid grid(Lists, { { { 1, 1, 1 } }, { { 2, 3, 4 } } }, 1);
  EXPECT_EQ(grid.Local(), (IndexBox{ { { 0, 0, 0 } }, { { 3, 4, 5 } } }));
  ForCells(grid.Local(),
    [&](const Index3& p)
    {
      const Index n = grid.Linear(p);
      ASSERT_EQ(grid.Position(n), p);
      ASSERT_EQ(grid.CellOfKey(grid.CellKey(p)), p);
      ASSERT_EQ(grid.NodeOfKey(grid.NodeKey(p)), p);
      for (int c = 0; c < 8; ++c)
      {
        ASSERT_EQ(grid.NodeOfCell(n, c), grid.Linear(CornerOfCell(p, c)));
        ASSERT_EQ(grid.CellOfNode(n, c), grid.Linear(CellOfStar(p, c)));
      }
      for (int face = 0; face < 6; ++face)
      {
        Index3 other = p;
        other[face / 2] += face % 2 ? 1 : -1;
        ASSERT_EQ(grid.Neighbour(n, face), grid.Linear(other));
      }
    });
}

TEST(CartesianGrid, PointsAreInTheirCells)
{
  const CartesianGrid grid(Lists);
  ForCells(grid.Global(), [&](const Index3& p) { ASSERT_EQ(grid.CellAt(grid.NodePoint(p)), p); });
  const Vector3 outside{ { -0.1, 3.5, 7.5 } };
  EXPECT_EQ(grid.CellAt(outside), (Index3{ { -1, 4, 2 } }));
  ForCells(grid.Global(),
    [&](const Index3& near)
    {
      ASSERT_EQ(grid.CellAt(outside, near), (Index3{ { -1, 4, 2 } }));
      ForCells(grid.Global(),
        [&](const Index3& p) { ASSERT_EQ(grid.CellAt(grid.NodePoint(p), near), p); });
    });
  EXPECT_EQ(grid.CellVolume({ { 1, 1, 2 } }), 8.0);
  EXPECT_EQ(grid.DomainSides({ { 0, 2, 5 } }), 1 << 0 | 1 << 5);
  EXPECT_FALSE(IsUniform(grid));
}

TEST(CartesianGrid, WrongCoordinatesAreErrors)
{
  EXPECT_THROW(CartesianGrid({ { { 0.0 }, { 0.0, 1.0 }, { 0.0, 1.0 } } }), InputError);
  EXPECT_THROW(CartesianGrid({ { { 0.0, 1.0, 1.0 }, { 0.0, 1.0 }, { 0.0, 1.0 } } }), InputError);
}

TEST(CartesianGrid, ColoursOfNodesWithACommonCellDiffer)
{
  const IndexBox owned{ { { 0, 0, 0 } }, { { 3, 4, 5 } } };
  const CartesianGrid grid =
    CartesianGrid::Covering(Lists, owned, { { true, true, true } }, Seam::Free, 2);
  EXPECT_EQ(grid.NumberOfColours(), 3 * 2 * 3);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      ASSERT_LT(grid.Colour(p), grid.NumberOfColours());
      ASSERT_EQ(grid.Colour(p), grid.Colour(grid.Canonical(p)));
      for (int n = 0; n < 27; ++n)
      {
        const Index3 other = CellAround(p, n);
        ASSERT_TRUE(n == 13 || !grid.InDomain(other) || grid.Colour(other) != grid.Colour(p));
      }
    });
}

TEST(CartesianGrid, CopiesAreWholePeriodsAway)
{
  const IndexBox owned{ { { 0, 0, 0 } }, { { 3, 4, 5 } } };
  const CartesianGrid grid =
    CartesianGrid::Covering(Lists, owned, { { true, false, true } }, Seam::Flat, 2);
  EXPECT_EQ(grid.PeriodLength(0), 4.0);
  EXPECT_EQ(grid.PeriodLength(1), 0.0);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      const Index3 same = grid.Canonical(p);
      ASSERT_TRUE(grid.Domain().Contains(same));
      for (int a = 0; a < 3; ++a)
      {
        const Index period = grid.Period(a);
        ASSERT_EQ(period > 0 ? (p[a] - same[a]) % period : p[a] - same[a], 0);
        ASSERT_EQ(grid.Width(a, p[a]), grid.Width(a, same[a]));
      }
    });
}

TEST(GlobalIds, TooManyAreAnError)
{
  const CartesianGrid grid(Lists);
  EXPECT_NO_THROW(CheckIds(grid, HexIds.PointSlots));
  EXPECT_THROW(CheckIds(grid, Index(1) << 60), InputError);
}
