/// Samples, edges and corners near nodes.
#include "GivenSurfaces/NearSurface.h"
#include "GivenCases.h"

#include "Base/PortableMath.h"

#include <gtest/gtest.h>

using namespace vfm;
using vfm::testing::GivenCase;

namespace
{

NodeFrame FrameAt(const Vector3& origin)
{
  return { {}, origin, { { 1.0, 1.0, 1.0 } } };
}

double AreaWithin(const NearSurface& surface, const Vector3& centre, double radius)
{
  std::vector<NearSample> samples;
  surface.ListSamples(FrameAt(centre), radius, samples);
  double area = 0.0;
  for (const NearSample& sample : samples)
  {
    area += sample.Weight;
  }
  return area;
}

const ClosedSurface Box = vfm::testing::BoxSurface({ { 2.3, 2.4, 2.5 } }, { { 9.3, 8.4, 7.5 } });

NearSurface NearBox(const GivenCase& box)
{
  return NearSurface(box.Surfaces, 0, 1.0, box.Surface);
}

TEST(NearSurface, SamplesStandForTheArea)
{
  const GivenCase box(12, { Box });
  EXPECT_NEAR(AreaWithin(NearBox(box), { { 6.0, 5.0, 7.5 } }, 2.0), 4.0 * Pi, 0.4);
  EXPECT_NEAR(AreaWithin(NearBox(box), { { 9.3, 8.4, 7.5 } }, 2.0), 3.0 * Pi, 0.3);
  EXPECT_EQ(AreaWithin(NearBox(box), { { 6.0, 5.0, 5.0 } }, 2.0), 0.0);
  // 13,448 triangles of about 0.013 cells^2: a part of them stands for all
  const GivenCase sphere(12, { vfm::testing::SphereSurface({ { 6, 6, 6 } }, 4.0, 82) });
  const NearSurface fine(sphere.Surfaces, 0, 1.0, sphere.Surface);
  EXPECT_NEAR(AreaWithin(fine, { { 10, 6, 6 } }, 3.0), 9.0 * Pi, 0.05 * 9.0 * Pi);
}

TEST(NearSurface, TheNearestPointsOfEdgesAndCornersAreFound)
{
  const GivenCase box(12, { Box });
  const NearSurface near = NearBox(box);
  std::vector<NearEdge> edges;
  near.ListEdges(FrameAt({ { 6.0, 8.0, 7.0 } }), 1.0, edges);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_NEAR(Norm(edges[0].At - Vector3{ { 0.0, 0.4, 0.5 } }), 0.0, 1e-12);
  EXPECT_NEAR(edges[0].Distance, std::sqrt(0.41), 1e-12);
  EXPECT_TRUE(edges[0].IsConvex);
  EXPECT_EQ(Dot(edges[0].Normals[0], edges[0].Normals[1]), 0.0);
  near.ListEdges(FrameAt({ { 6.0, 8.0, 7.0 } }), 0.6, edges);
  EXPECT_TRUE(edges.empty());
  std::vector<NearCorner> corners;
  near.ListCorners(FrameAt({ { 9.0, 8.0, 7.0 } }), 1.0, corners);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners[0].Sheets.size(), 3u);
  EXPECT_EQ(corners[0].Normals.size(), 3u);
  EXPECT_NEAR(Norm(corners[0].At - Vector3{ { 0.3, 0.4, 0.5 } }), 0.0, 1e-12);
}

TEST(NearSurface, EdgesEndAtTheDomain)
{
  const GivenCase box(12, { vfm::testing::BoxSurface({ { 4, 4, 4 } }, { { 13, 12.2, 8 } }) });
  const NearSurface near(box.Surfaces, 0, 1.0, box.Surface);
  std::vector<NearEdge> edges;
  near.ListEdges(FrameAt({ { 11, 4.5, 8 } }), 2.0, edges);
  ASSERT_EQ(edges.size(), 1u); // not the upper one beyond the side
  near.ListEdges(FrameAt({ { 12, 12, 8 } }), 2.0, edges);
  EXPECT_TRUE(edges.empty());
  std::vector<NearCorner> corners;
  near.ListCorners(FrameAt({ { 12, 12, 8 } }), 2.0, corners);
  EXPECT_TRUE(corners.empty());
  EXPECT_NEAR(AreaWithin(near, { { 11, 8, 8 } }, 3.0), 33.0, 1.0); // also beyond the side
}

/// A bar that ends in a side of the domain continues beyond it, or repeats.
TEST(NearSurface, TrianglesInSidesOfTheDomainDoNotCount)
{
  const GivenCase bar(12, { vfm::testing::BoxSurface({ { 0, 4, 4 } }, { { 7, 8, 8 } }) });
  const NearSurface near(bar.Surfaces, 0, 1.0, bar.Surface);
  EXPECT_EQ(AreaWithin(near, { { 0, 6, 6 } }, 1.5), 0.0);
  EXPECT_NEAR(AreaWithin(near, { { 7, 6, 6 } }, 1.5), 2.25 * Pi, 0.3);
  std::vector<NearEdge> edges;
  near.ListEdges(FrameAt({ { 0, 4, 6 } }), 1.0, edges);
  EXPECT_TRUE(edges.empty());
  near.ListEdges(FrameAt({ { 0, 4, 4 } }), 1.0, edges);
  EXPECT_EQ(edges.size(), 1u); // along the bar
  std::vector<NearCorner> corners;
  near.ListCorners(FrameAt({ { 0, 4, 4 } }), 1.0, corners);
  EXPECT_TRUE(corners.empty());
}

TEST(NearSurface, CellsOfOtherShapesAreUnitCubes)
{
  std::array<std::vector<double>, 3> x = GivenCase::Coordinates(12);
  for (double& z : x[2])
  {
    z *= 0.25;
  }
  const InputSurfaces bodies = vfm::testing::MakeBodies(
    { vfm::testing::BoxSurface({ { 2.3, 2.4, 0.6 } }, { { 9.3, 8.4, 1.9 } }) });
  const CartesianGrid grid(x);
  const FractionField fractions = vfm::testing::FractionsOfBodies(grid, bodies);
  const LabelArray labels = AssignMaterials(grid, fractions, 0.5);
  Runtime runtime;
  const Interface interface(grid, fractions, labels, FindMixedNodes(grid, labels), 0.5, runtime);
  const BodySurfaces surfaces(bodies, { "1" }, grid, 40.0);
  const NearSurface near(surfaces, 0, 1.0, interface);
  const double scale = interface.Scale();
  const NodeFrame frame{ {}, { { 9.0 / scale, 5.0 / scale, 1.25 / scale } },
    { { 1.0 / scale, 1.0 / scale, 0.25 / scale } } };
  std::vector<NearSample> samples;
  near.ListSamples(frame, 2.0, samples);
  double area = 0.0;
  for (const NearSample& sample : samples)
  {
    EXPECT_NEAR(sample.At[0], 0.3, 1e-12);
    EXPECT_NEAR(sample.Normal[0], 1.0, 1e-12);
    area += sample.Weight;
  }
  EXPECT_NEAR(area, Pi * (4.0 - 0.09), 0.5);
}

TEST(NearSurface, ABodyRepeatsWithTheDomain)
{
  const InputSurfaces bodies = vfm::testing::MakeBodies({ Box });
  const CartesianGrid grid = CartesianGrid::Covering(GivenCase::Coordinates(12),
    { { 0, 0, 0 }, { 12, 12, 12 } }, { true, false, false }, Seam::Free, GhostLayers);
  const FractionField fractions(grid, 1);
  const LabelArray labels = AssignMaterials(grid, fractions, 0.5);
  Runtime runtime;
  const Interface interface(grid, fractions, labels, {}, 0.5, runtime);
  const BodySurfaces surfaces(bodies, { "1" }, grid, 40.0);
  const NearSurface near(surfaces, 0, 1.0, interface);
  const double layers = -grid.Coordinates(0).front(); // before the domain
  for (double period : { -12.0, 0.0, 12.0 })
  {
    const double x = layers + (period < 0 ? 9.3 : 2.3) + period;
    EXPECT_NEAR(AreaWithin(near, { { x, 5.0, 5.0 } }, 2.0), 4.0 * Pi, 0.4) << period;
  }
}

} // namespace
