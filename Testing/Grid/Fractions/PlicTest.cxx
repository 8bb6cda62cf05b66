/// Volumes below a plane in a cell.
#include "Fractions/Plic.h"
#include "Base/ConvexClip.h"
#include "Base/Vector3.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using vfm::testing::RandomDraw;

namespace
{

double ClippedVolume(const Vector3& n, double d)
{
  const ConvexPiece box = MakeBoxPiece({ { -0.5, -0.5, -0.5 } }, { { 0.5, 0.5, 0.5 } });
  ConvexPiece below, above;
  std::vector<Vector3> section;
  ClipPiece(box, { Unit(n), d / Norm(n) }, below, above, section);
  return ComputeVolume(below);
}

} // namespace

TEST(Plic, VolumesAreThoseOfPolyhedra)
{
  RandomDraw random(1);
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 n{ { random.Between(-1, 1), random.Between(-1, 1),
      i % 3 ? random.Between(-1, 1) : 0.0 } };
    const double d = random.Between(-1.2, 1.2);
    ASSERT_NEAR(VolumeBelowPlane(n, d), ClippedVolume(n, d), 1e-12)
      << ::testing::PrintToString(n) << d;
  }
}

/// Very small components of the normal do not cause cancellation.
TEST(Plic, VolumesOfPlanesAlongTheGrid)
{
  RandomDraw random(1);
  for (int i = 0; i < 20000; ++i)
  {
    const double a = std::pow(10.0, random.Between(-13, -3)),
                 b = std::pow(10.0, random.Between(-13, -3));
    const double d = random.Between(-0.49, 0.49);
    ASSERT_NEAR(VolumeBelowPlane({ { a, -b, 1.0 } }, d), 0.5 + d, 1e-15) << a << " " << b;
  }
}

TEST(Plic, PlanesHaveTheirVolume)
{
  RandomDraw random(1);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 n{ { random.Between(-1, 1), random.Between(-1, 1),
      std::pow(10.0, random.Between(-12, 0)) } };
    const double fraction = random.Between(0, 1);
    ASSERT_NEAR(VolumeBelowPlane(n, PlaneOfVolume(n, fraction)), fraction, 1e-11);
  }
}

/// Newton's method before the bisection changes no bit of its result.
TEST(Plic, PlanesAreThoseOfABisection)
{
  RandomDraw random(3);
  const auto draw = [&] { return std::floor(0x1p20 * random.Between(0.0, 0.5)) * 0x1p-20; };
  for (int i = 0; i < 20000; ++i)
  {
    // The components sum to exactly 1, so that no place of a plane is rounded.
    const double x = i % 4 ? draw() : 0x1p-20, y = i % 5 ? draw() : 0.0;
    const CellBelowPlanes cell(Vector3{ { x, y, 1.0 - x - y } });
    const double fraction = i % 3 ? random.Between(0, 1) : std::pow(10.0, random.Between(-15, 0));
    double low = 0.0, high = 1.0;
    while (high - low > 1e-12)
    {
      const double middle = 0.5 * (low + high);
      (cell.Volume(middle - 0.5) < fraction ? low : high) = middle;
    }
    ASSERT_EQ(cell.PlaneOf(fraction), 0.5 * (low + high) - 0.5) << fraction;
  }
}

TEST(Plic, SlopesAreDifferencesOfVolumes)
{
  RandomDraw random(2);
  constexpr double Step = 1e-7;
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 n{ { random.Between(0.1, 1), -random.Between(0.1, 1), random.Between(0.1, 1) } };
    const CellBelowPlanes cell(n);
    const double d = random.Between(-1.2, 1.2) * cell.Reach();
    const double difference = (cell.Volume(d + Step) - cell.Volume(d - Step)) / (2.0 * Step);
    ASSERT_NEAR(cell.Slope(d), difference, 2e-5) << d; // second derivatives are at most 100
  }
}
