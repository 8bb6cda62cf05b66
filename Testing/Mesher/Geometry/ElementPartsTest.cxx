/// Parts of elements.
#include "Geometry/ElementParts.h"
#include "Base/HexVolume.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns the corners of a cube of two units, moved by up to a distance, in VTK's order.
std::array<Vector3, 8> MakeHex(RandomDraw& random, double distance)
{
  std::array<Vector3, 8> x;
  for (int c = 0; c < 8; ++c)
  {
    const int bits = c ^ (c >> 1 & 1);
    x[c] = random.Vector(-distance, distance);
    for (int a = 0; a < 3; ++a)
    {
      x[c][a] += 2.0 * (bits >> a & 1);
    }
  }
  return x;
}

} // namespace

TEST(ElementParts, PartsOfACubeAreItsOctants)
{
  RandomDraw random(1);
  std::vector<Vector3> centres;
  ForPartsOfHex(MakeHex(random, 0.0), 8.0,
    [&](const Vector3& centre, double volume)
    {
      centres.push_back(centre);
      EXPECT_DOUBLE_EQ(volume, 1.0);
    });
  ASSERT_EQ(centres.size(), 8u);
  for (int n = 0; n < 8; ++n)
  {
    EXPECT_EQ(centres[n], (Vector3{ { 0.5 + (n & 1), 0.5 + (n >> 1 & 1), 0.5 + (n >> 2) } }));
  }
}

/// The parts of a hex whose map is linear have equal volumes and the hex's centroid; those of any
/// hex have its volume, and centres where the trilinear map has them.
TEST(ElementParts, PartsOfAnyHex)
{
  RandomDraw random(2);
  for (int i = 0; i < 200; ++i)
  {
    const std::array<Vector3, 8> x = MakeHex(random, 0.4);
    double sum = 0.0;
    int n = 0;
    ForPartsOfHex(x, VolumeOfHex(x),
      [&](const Vector3& centre, double volume)
      {
        sum += volume;
        EXPECT_GT(volume, 0.0);
        Vector3 expected{};
        for (int c = 0; c < 8; ++c)
        {
          const int differs = c ^ (c >> 1 & 1) ^ n;
          double weight = 1.0;
          for (int a = 0; a < 3; ++a)
          {
            weight *= differs >> a & 1 ? 0.25 : 0.75;
          }
          expected = expected + weight * x[c];
        }
        EXPECT_LT(Norm(centre - expected), 1e-14);
        ++n;
      });
    EXPECT_NEAR(sum, VolumeOfHex(x), 1e-13);
  }
}

/// The first part of a hex with one long edge is smaller than that at the other end.
TEST(ElementParts, VolumesFollowTheJacobian)
{
  std::array<Vector3, 8> x;
  for (int c = 0; c < 8; ++c)
  {
    const int bits = c ^ (c >> 1 & 1);
    const double half = bits & 1 ? 1.5 : 0.5; // a pyramid's frustum along x
    x[c] = { { bits & 1 ? 1.0 : 0.0, bits >> 1 & 1 ? half : -half, bits >> 2 ? half : -half } };
  }
  std::vector<double> volumes;
  ForPartsOfHex(x, VolumeOfHex(x), [&](const Vector3&, double v) { volumes.push_back(v); });
  // Widths at 1/4 and 3/4 are 1.5 and 2.5.
  EXPECT_NEAR(volumes[1] / volumes[0], 6.25 / 2.25, 1e-13);
}

TEST(ElementParts, PartsOfATetHaveItsCentroid)
{
  const std::array<Vector3, 8> x{ { { { 0, 0, 0 } }, { { 3, 0, 1 } }, { { 0, 2, 0 } },
    { { 1, 1, 4 } } } };
  Vector3 moment{};
  double sum = 0.0;
  ForPartsOfTet(x, 5.0,
    [&](const Vector3& centre, double volume)
    {
      moment = moment + volume * centre;
      sum += volume;
    });
  EXPECT_NEAR(sum, 5.0, 1e-14);
  EXPECT_LT(Norm((1.0 / sum) * moment - 0.25 * (x[0] + x[1] + x[2] + x[3])), 1e-14);
}
