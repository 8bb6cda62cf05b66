/// Volumes in a box from functions that are linear: planes, wedges and overlapping half-spaces.
#include "Fractions/LevelSetVolumes.h"

#include "Fractions/Plic.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace vfm;

namespace
{

/// Returns the values of n.x - d at the corners of the unit cell around the origin.
CornerValues PlaneValues(const Vector3& n, double d)
{
  CornerValues values{};
  for (int c = 0; c < 8; ++c)
  {
    values[c] = -d;
    for (int a = 0; a < 3; ++a)
    {
      values[c] += n[a] * ((c >> a & 1) - 0.5);
    }
  }
  return values;
}

std::vector<double> VolumesOf(const std::vector<CornerValues>& functions, LevelSetRule rule)
{
  std::vector<double> volumes(functions.size() + 1, 0.0);
  AddVolumesInBox(functions, rule, 1.0, volumes);
  return volumes;
}

} // namespace

TEST(LevelSetVolumes, PlanesAsPlic)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int n = 0; n < 500; ++n)
  {
    const Vector3 normal{ { draw(random), draw(random), n % 5 == 0 ? 0.0 : draw(random) } };
    const double d = 0.8 * draw(random);
    const double expected = VolumeBelowPlane(normal, d);
    for (LevelSetRule rule : { LevelSetRule::Priority, LevelSetRule::Lowest })
    {
      const std::vector<double> found = VolumesOf({ PlaneValues(normal, d) }, rule);
      EXPECT_NEAR(found[1], expected, 1e-14);
      EXPECT_NEAR(found[0], 1.0 - expected, 1e-14);
    }
    EXPECT_EQ(VolumesOf({ PlaneValues(normal, d) }, LevelSetRule::Fill)[1], 1.0);
  }
}

TEST(LevelSetVolumes, NestedHalfSpacesArePlies)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int n = 0; n < 300; ++n)
  {
    const Vector3 normal{ { draw(random), draw(random), draw(random) } };
    const double low = 0.4 * draw(random), high = low + 0.02;
    const std::vector<double> found =
      VolumesOf({ PlaneValues(normal, low), PlaneValues(normal, high) }, LevelSetRule::Priority);
    const double below = VolumeBelowPlane(normal, low);
    EXPECT_NEAR(found[1], below, 1e-14);
    EXPECT_NEAR(found[2], VolumeBelowPlane(normal, high) - below, 1e-14);
    EXPECT_NEAR(std::accumulate(found.begin(), found.end(), 0.0), 1.0, 1e-14);
  }
}

TEST(LevelSetVolumes, CrossingHalfSpaces)
{
  const std::vector<CornerValues> functions{ PlaneValues({ { 1, 0, 0 } }, 0.1),
    PlaneValues({ { 0, 1, 0 } }, 0.2) };
  const std::vector<double> first = VolumesOf(functions, LevelSetRule::Priority);
  EXPECT_NEAR(first[1], 0.6, 1e-15);
  EXPECT_NEAR(first[2], 0.7 - 0.6 * 0.7, 1e-15);
  EXPECT_NEAR(first[0], 0.4 * 0.3, 1e-15);
  // x - 0.1 and y - 0.2: the diagonal y = x + 0.1 divides where both or one are negative.
  const std::vector<double> lowest = VolumesOf(functions, LevelSetRule::Lowest);
  EXPECT_NEAR(lowest[0], 0.4 * 0.3, 1e-15);
  EXPECT_NEAR(lowest[1] + lowest[2], 0.88, 1e-15);
  EXPECT_NEAR(lowest[1], 0.6 * 0.3 + 0.5 * 0.6 * 0.6, 1e-15); // triangle of 0.6, rectangle above
  const std::vector<double> filled = VolumesOf(functions, LevelSetRule::Fill);
  EXPECT_EQ(filled[0], 0.0);
  EXPECT_NEAR(filled[1], 0.5 * 0.9 * 0.9, 1e-15);
}

/// Equal functions belong to the first of them; three planes through a line share the box.
TEST(LevelSetVolumes, TiesAndJunctions)
{
  const CornerValues half = PlaneValues({ { 0.3, 0.4, 1.0 } }, 0.05);
  for (LevelSetRule rule : { LevelSetRule::Priority, LevelSetRule::Lowest, LevelSetRule::Fill })
  {
    const std::vector<double> found = VolumesOf({ half, half }, rule);
    EXPECT_LT(found[2], 1e-15);
    EXPECT_GT(found[1], 0.5);
  }
  const double s = 0.86602540378443864676;
  const std::vector<double> found =
    VolumesOf({ PlaneValues({ { 1.0, 0.0, 0.0 } }, 0.0), PlaneValues({ { -0.5, s, 0.0 } }, 0.0),
                PlaneValues({ { -0.5, -s, 0.0 } }, 0.0) },
      LevelSetRule::Fill);
  EXPECT_EQ(found[0], 0.0);
  EXPECT_NEAR(found[2], found[3], 1e-15);
  EXPECT_NEAR(found[1] + found[2] + found[3], 1.0, 1e-15);
  // The sector of 120 degrees around -x, up to the sides of the square.
  EXPECT_NEAR(found[1], 0.5 - s / 1.5 * 0.25, 1e-14);
}
