/// Targets and edges from given surfaces, and whole meshes with them.
#include "GivenSurfaces/FollowSurfaces.h"
#include "GivenCases.h"

#include "SharpFeatures/FeaturePlaces.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const Vector3 Centre{ { 9.2, 9.1, 9.3 } };

ClosedSurface TurnedBox(double half, const Vector3& centre = Centre)
{
  const Vector3 edge{ { half, half, 0.7 * half } };
  return Turned(BoxSurface(centre - edge, centre + edge), centre, { { 20, 30, 40 } });
}

double LargestDistance(const GivenCase& given, const SurfaceTargets& targets, double radius)
{
  double largest = 0.0;
  for (std::size_t p = 0; p < given.Surface.Points().size(); ++p)
  {
    const Vector3 outwards = Unit(given.Surface.Points()[p].Point - Centre);
    Vector3 gradient;
    const double distance =
      targets.Distance(static_cast<Index>(p), Centre + radius * outwards, gradient);
    largest = std::max(largest, std::fabs(distance));
  }
  return largest;
}

TEST(FollowSurfaces, TargetsLieOnTheSurface)
{
  GivenCase sphere(18, { SphereSurface(Centre, 5.0, 96) });
  SurfaceTargets targets(sphere.Surface, SurfaceTargets::Kind::Quadrics, sphere.Run);
  EXPECT_GT(LargestDistance(sphere, targets, 5.0), 0.01);
  const SharpFeatures features =
    FollowSurfaces(sphere.Surfaces, { &sphere.Surface }, true, sphere.Run, targets);
  EXPECT_LT(LargestDistance(sphere, targets, 5.0), 0.008);
  EXPECT_TRUE(features.IsEmpty());
}

/// The body of which the second label is inside, and the one of which it is outside.
TEST(FollowSurfaces, EdgesAreThoseOfTheFirstBody)
{
  const std::vector<ClosedSurface> around{ TurnedBox(4.0),
    BoxSurface({ { 1, 1, 1 } }, { { 17, 17, 17 } }) };
  for (const std::vector<ClosedSurface>& bodies :
    { std::vector<ClosedSurface>{ around[0] }, around })
  {
    GivenCase box(18, bodies);
    SurfaceTargets targets(box.Surface, SurfaceTargets::Kind::Quadrics, box.Run);
    const SharpFeatures features =
      FollowSurfaces(box.Surfaces, { &box.Surface }, true, box.Run, targets);
    int inner = 0, found = 0;
    for (std::size_t p = 0; p < box.Surface.Points().size(); ++p)
    {
      const SurfacePoint& point = box.Surface.Points()[p];
      if (point.First == (bodies.size() == 1 ? 0 : 1))
      {
        ++inner;
        const NodeFeature* feature = features.Find(static_cast<Index>(p));
        found += feature != nullptr && FindEdge(feature->Model, {}).has_value();
      }
    }
    EXPECT_GT(inner, 200);
    EXPECT_GT(found, inner / 2);
    SurfaceTargets smooth(box.Surface, SurfaceTargets::Kind::Quadrics, box.Run);
    EXPECT_TRUE(FollowSurfaces(box.Surfaces, { &box.Surface }, false, box.Run, smooth).IsEmpty());
  }
}

TEST(FollowSurfaces, PairsWithoutASurfaceKeepTheirTargets)
{
  GivenCase box(18, { TurnedBox(4.0) });
  const BodySurfaces none(box.Bodies, { "other" }, box.Grid, 40.0);
  SurfaceTargets targets(box.Surface, SurfaceTargets::Kind::Quadrics, box.Run);
  const SurfaceTargets before = targets;
  EXPECT_TRUE(FollowSurfaces(none, { &box.Surface }, true, box.Run, targets).IsEmpty());
  for (Index t = 0; t < targets.Count(); ++t)
  {
    Vector3 a, b;
    EXPECT_EQ(targets.Distance(t, Centre, a), before.Distance(t, Centre, b));
  }
}

} // namespace
