/// Nodes of a level near interfaces.
#include "Elements/Hex/NodesNear.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using vfm::testing::RandomDraw;

namespace
{

bool IsWithin(const Index3& a, const Index3& b, Index distance)
{
  return std::abs(a[0] - b[0]) <= distance && std::abs(a[1] - b[1]) <= distance &&
    std::abs(a[2] - b[2]) <= distance;
}

} // namespace

TEST(NodesNear, AreThoseWithinTheRings)
{
  std::vector<double> x(17);
  std::iota(x.begin(), x.end(), 0.0);
  const CartesianGrid grid(std::array<std::vector<double>, 3>{ { x, x, x } });
  RandomDraw random(9);
  for (const auto& [halvings, rings] :
    std::vector<std::array<int, 2>>{ { { 0, 1 } }, { { 1, 0 } }, { { 1, 2 } }, { { 2, 1 } } })
  {
    std::vector<Index> mixed(12);
    std::vector<Index3> places; // of the nodes in the level
    for (Index& node : mixed)
    {
      const Index3 p{ { random.Whole(0, 16), random.Whole(0, 16), random.Whole(0, 16) } };
      places.push_back({ { p[0] >> halvings, p[1] >> halvings, p[2] >> halvings } });
      node = grid.Linear(p);
    }
    const NodesNear near(grid, mixed, halvings, rings);
    const Index end = (16 >> halvings) + 1;
    for (Index n = 0; n < end * end * end; ++n)
    {
      const Index3 p = CellInBox({ {}, { { end, end, end } } }, n);
      bool isNear = false;
      for (const Index3& place : places)
      {
        isNear = isNear || IsWithin(p, place, rings);
      }
      ASSERT_EQ(near.Has(p), isNear) << TextOf(p);
    }
  }
}
