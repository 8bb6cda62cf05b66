/// Coordinates of the grid, and sides of the domain.
#include "Elements/GridCoordinates.h"

#include <gtest/gtest.h>

using namespace vfm;

TEST(GridCoordinates, StartAtTheLowestNodeInCells)
{
  const CartesianGrid grid({ { { 3.0, 3.5, 4.0 }, { -1.0, -0.5, 0.0 }, { 7.0, 7.5, 8.0 } } });
  ForCells(NodesOf(grid.Global()),
    [&](const Index3& p)
    {
      const Vector3 point = grid.NodePoint(p), at = ToGrid(grid, point.data());
      for (int a = 0; a < 3; ++a)
      {
        ASSERT_DOUBLE_EQ(at[a], static_cast<double>(p[a]));
      }
      ASSERT_EQ(FindDomainSides(grid, point.data()), grid.DomainSides(p));
    });
}
