/// Samples of closed surfaces, nearest triangles and thickness.
#include "Surfaces/SurfaceThickness.h"

#include "Base/ThreadRuntime.h"
#include "NearestTriangle.h"
#include "RandomDraw.h"
#include "SurfaceCases.h"
#include "Surfaces/SurfaceSamples.h"
#include "Surfaces/TriangleSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const Vector3 Zero{ { 0, 0, 0 } };

std::vector<double> Measure(const ClosedSurface& surface, BallSide side, int count,
  std::vector<SurfaceSample>* samples = nullptr)
{
  Runtime runtime;
  const std::vector<SurfaceSample> own = SampleSurface(surface, FindComponents(surface), count);
  if (samples)
  {
    *samples = own;
  }
  return MeasureThickness(own, TriangleSearch(PlaceTriangles(surface), runtime), side, runtime);
}

double ThinQuantile(const ClosedSurface& surface, double share = ThinShare)
{
  std::vector<SurfaceSample> samples;
  const std::vector<double> values = Measure(surface, BallSide::Inner, 4000, &samples);
  return FindQuantile(samples, values, share);
}

TEST(TriangleSearch, FindsTheNearest)
{
  RandomDraw draw(3);
  std::vector<Triangle> triangles;
  for (int t = 0; t < 300; ++t)
  {
    const Vector3 at = draw.Vector(0.0, 10.0);
    triangles.push_back({ { at, at + draw.Vector(-1.0, 1.0), at + draw.Vector(-1.0, 1.0) } });
  }
  triangles.push_back({ { Zero, Zero, Zero } });
  Runtime runtime;
  const TriangleSearch search(triangles, runtime);
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 x = draw.Vector(-3.0, 13.0);
    double least = 1e300, leastEven = 1e300;
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    {
      const double distance = DistanceToTriangle(x, triangles[t]);
      least = std::min(least, distance);
      leastEven = t % 2 == 0 ? std::min(leastEven, distance) : leastEven;
    }
    const TriangleSearch::Nearest all = search.Find(x, 100.0);
    EXPECT_NEAR(std::sqrt(all.Square), least, 1e-9);
    EXPECT_NEAR(Norm(all.Point - x), least, 1e-9);
    const TriangleSearch::Nearest even = search.Find(x, 100.0, [](int t) { return t % 2 == 0; });
    EXPECT_NEAR(std::sqrt(even.Square), leastEven, 1e-9);
    EXPECT_EQ(even.Triangle % 2, 0);
    EXPECT_EQ(search.Find(x, 0.9 * least).Triangle, -1);
  }
}

TEST(SurfaceSamples, StandForEqualAreas)
{
  const ClosedSurface plate = BoxSurface(Zero, { { 10, 20, 1 } }, 3);
  const ClosedSurface both = Together(plate, BoxSurface({ { 30, 0, 0 } }, { { 31, 1, 1 } }));
  const SurfaceComponents components = FindComponents(both);
  EXPECT_EQ(components.Solids, 2);
  ASSERT_EQ(components.Volumes.size(), 2u);
  EXPECT_NEAR(components.Volumes[0], 200.0, 1e-9);
  EXPECT_NEAR(components.Volumes[1], 1.0, 1e-9);
  const std::vector<SurfaceSample> samples = SampleSurface(both, components, 2000);
  EXPECT_LT(samples.size(), 2100u);
  double total = 0.0, top = 0.0, quarter = 0.0, small = 0.0;
  for (const SurfaceSample& sample : samples)
  {
    total += sample.Area;
    top += sample.Point[2] == 1.0 && sample.Point[0] < 20.0 ? sample.Area : 0.0;
    quarter +=
      sample.Point[2] == 1.0 && sample.Point[0] < 5.0 && sample.Point[1] < 10.0 ? sample.Area : 0.0;
    small += sample.Point[0] >= 30.0 ? 1.0 : 0.0;
  }
  EXPECT_NEAR(total, 2 * 200 + 2 * 10 + 2 * 20 + 6, 1e-9);
  EXPECT_NEAR(top, 200.0, 2.0);
  EXPECT_NEAR(quarter, 50.0, 2.0);
  EXPECT_GE(small, 24.0);
}

TEST(SurfaceThickness, OfSimpleBodies)
{
  EXPECT_NEAR(ThinQuantile(BoxSurface(Zero, { { 10, 8, 3 } }, 4)), 3.0, 1e-9);
  EXPECT_NEAR(ThinQuantile(BoxSurface(Zero, { { 10, 8, 3 } }, 4), 0.9), 10.0, 2.0 + 1e-9);
  EXPECT_NEAR(ThinQuantile(SphereSurface(Zero, 5.0, 60)), 10.0, 0.2);
  EXPECT_NEAR(ThinQuantile(TubeSurface(Zero, 30.0, 5.0, 4.2, 100)), 0.8, 0.02);
  const ClosedSurface hollow =
    Together(SphereSurface(Zero, 5.0, 60), Reversed(SphereSurface(Zero, 4.0, 60)));
  EXPECT_EQ(FindComponents(hollow).Solids, 1);
  EXPECT_NEAR(ThinQuantile(hollow), 1.0, 0.02);
  EXPECT_NEAR(ThinQuantile(hollow, 0.95), 1.0, 0.02);
}

TEST(SurfaceThickness, OfGaps)
{
  const ClosedSurface two = Together(
    BoxSurface(Zero, { { 10, 10, 4 } }, 2), BoxSurface({ { 0, 0, 5 } }, { { 10, 10, 9 } }, 2));
  std::vector<SurfaceSample> samples;
  const std::vector<double> gaps = Measure(two, BallSide::Outer, 3000, &samples);
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    const double z = samples[s].Point[2];
    if (z == 4.0 || z == 5.0)
    {
      EXPECT_NEAR(gaps[s], 1.0, 1e-9);
    }
    else
    {
      EXPECT_TRUE(std::isinf(gaps[s]));
    }
  }
  const std::vector<double> inner = Measure(two, BallSide::Inner, 3000);
  EXPECT_NEAR(*std::min_element(inner.begin(), inner.end()), 4.0, 1e-9);
}

TEST(SurfaceThickness, UpToALimit)
{
  const ClosedSurface box = BoxSurface(Zero, { { 10, 8, 3 } }, 4);
  const std::vector<SurfaceSample> samples = SampleSurface(box, FindComponents(box), 1000);
  Runtime runtime;
  const TriangleSearch search(PlaceTriangles(box), runtime);
  const std::vector<double> all =
    MeasureThicknessTo(4.0, samples, search, BallSide::Inner, runtime);
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    EXPECT_NEAR(all[s], samples[s].Normal[2] == 0.0 ? 4.0 : 3.0, 1e-9);
    EXPECT_EQ(MeasureThicknessTo(4.0, { samples[s] }, search, BallSide::Inner, runtime)[0], all[s]);
  }
  for (double gap : MeasureThicknessTo(4.0, samples, search, BallSide::Outer, runtime))
  {
    EXPECT_EQ(gap, 4.0);
  }
}

TEST(SurfaceThickness, DoesNotDependOnThreads)
{
  const ClosedSurface tube = TubeSurface({ { 0.1, 0.2, 0.3 } }, 20.0, 5.0, 4.0, 64);
  const std::vector<SurfaceSample> samples = SampleSurface(tube, FindComponents(tube), 2000);
  Runtime serial;
  ThreadRuntime threads(3);
  const auto measure = [&](Runtime& runtime)
  {
    return MeasureThickness(
      samples, TriangleSearch(PlaceTriangles(tube), runtime), BallSide::Inner, runtime);
  };
  EXPECT_EQ(measure(serial), measure(threads));
}

} // namespace
