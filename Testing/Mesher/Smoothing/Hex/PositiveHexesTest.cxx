/// Hexes with small coefficients are found in all hexes or in those at given points.
#include "Smoothing/Hex/PositiveHexes.h"
#include "Base/ThreadRuntime.h"
#include "Cells/HexBlock.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Flags = std::vector<unsigned char>;

constexpr int Points = 12; // of the block, along each axis

} // namespace

TEST(PositiveHexes, FewPointsLeadToTheHexesThatAllLeadTo)
{
  RandomDraw draw(5);
  ThreadRuntime runtime(3, nullptr);
  ActiveMesh mesh = MakeHexBlock(Points);
  const std::vector<Vector3> start = mesh.X;
  const std::size_t count = mesh.X.size();
  int found = 0;
  for (int moves = 0; moves < 600; moves += 20) // above a quarter of 1,728, all are looked at
  {
    mesh.X = start;
    Flags moved(count, 0), all(count, 0), near(count, 0);
    for (int move = 0; move < moves; ++move)
    {
      const auto point = static_cast<std::size_t>(draw.Between(0.0, static_cast<double>(count)));
      mesh.X[point] = start[point] + draw.Vector(-0.45, 0.45);
      moved[point] = 1;
    }
    const bool isAny = MarkSmallCoefficients(mesh, runtime, {}, {}, all);
    EXPECT_EQ(MarkSmallCoefficients(mesh, runtime, {}, moved, near), isAny);
    EXPECT_EQ(near, all) << moves;
    found += isAny;
  }
  EXPECT_GT(found, 10);
}

TEST(PositiveHexes, HexesAtOtherPointsAreLeftOut)
{
  Runtime serial;
  ActiveMesh mesh = MakeHexBlock(Points);
  const int middle = Points / 2 * (1 + Points + Points * Points);
  mesh.X[middle][0] += 1.5;
  Flags points(mesh.X.size(), 0), where(mesh.X.size(), 0);
  where[0] = 1;
  EXPECT_FALSE(MarkSmallCoefficients(mesh, serial, {}, where, points));
  where[middle + 1] = 1;
  EXPECT_TRUE(MarkSmallCoefficients(mesh, serial, {}, where, points));
  EXPECT_EQ(points[middle], 1);
  EXPECT_EQ(points[middle + 1], 1);
  EXPECT_EQ(points[middle + 2], 0);
  EXPECT_FALSE(KeepPositiveCoefficients(mesh, middle + 1, mesh.X[middle + 2]));
  EXPECT_TRUE(KeepPositiveCoefficients(mesh, 0, { { 0.1, 0.1, 0.1 } }));
}
