/// Models of the sharp edges of surfaces.
#include "GivenSurfaces/EdgeModels.h"
#include "GivenCases.h"

#include <gtest/gtest.h>

using namespace vfm;
using vfm::testing::GivenCase;

namespace
{

/// Surroundings of a node for an interface whose second label is inside of the body.
NodeSurroundings Around(const ClosedSurface& surface, const Vector3& origin)
{
  const GivenCase given(16, { surface });
  const NearSurface near(given.Surfaces, 0, 1.0, given.Surface);
  const NodeFrame frame{ {}, origin, { { 1.0, 1.0, 1.0 } } };
  NodeSurroundings around;
  near.ListSamples(frame, EdgeReach + 2.0, around.Samples);
  near.ListEdges(frame, EdgeReach, around.Edges);
  near.ListCorners(frame, CornerReach, around.Corners);
  for (NearSample& sample : around.Samples)
  {
    sample.Normal = -1.0 * sample.Normal;
  }
  for (NearEdge& edge : around.Edges)
  {
    edge.Normals = { -1.0 * edge.Normals[0], -1.0 * edge.Normals[1] };
  }
  for (NearCorner& corner : around.Corners)
  {
    for (Vector3& normal : corner.Normals)
    {
      normal = -1.0 * normal;
    }
  }
  return around;
}

/// Expects that the model has the second label inside of a solid, at points up to 1.5 cells away.
template <class Solid>
void ExpectSolid(const FeatureModel& model, const Vector3& origin, const Solid& isInside)
{
  for (double x = -1.45; x < 1.5; x += 0.29)
  {
    for (double y = -1.45; y < 1.5; y += 0.29)
    {
      for (double z = -1.45; z < 1.5; z += 0.29)
      {
        int bits = 0;
        for (int k = 0; k < model.Count; ++k)
        {
          Vector3 gradient;
          bits |= DistanceTo(model.Surfaces[k], { { x, y, z } }, gradient) > 0.0 ? 1 << k : 0;
        }
        EXPECT_EQ(IsInside(model, bits), isInside(origin + Vector3{ { x, y, z } }))
          << x << " " << y << " " << z;
      }
    }
  }
}

const Vector3 Lower{ { 3, 3, 3 } }, Upper{ { 12.1, 12.2, 12.3 } };

bool IsInBox(const Vector3& x)
{
  return x[0] > Lower[0] && x[1] > Lower[1] && x[2] > Lower[2] && x[0] < Upper[0] &&
    x[1] < Upper[1] && x[2] < Upper[2];
}

TEST(EdgeModels, EdgesAndCornersOfABox)
{
  const ClosedSurface box = vfm::testing::BoxSurface(Lower, Upper, 3);
  for (const Vector3& node :
    { Vector3{ { 12, 12, 8 } }, Vector3{ { 12, 12, 12 } }, Vector3{ { 11, 12, 11 } } })
  {
    const auto model = MakeEdgeModel(Around(box, node), { { -1, 0, 0 } });
    ASSERT_TRUE(model);
    EXPECT_EQ(model->Model.Count, node[2] < 10 ? 2 : 3);
    ExpectSolid(model->Model, node, IsInBox);
  }
  EXPECT_FALSE(MakeEdgeModel(Around(box, { { 12, 8, 8 } }), { { -1, 0, 0 } }));
  // an edge of which no side faces like the interface
  EXPECT_FALSE(MakeEdgeModel(Around(box, { { 12, 12, 8 } }), { { 1, 0, 0 } }));
}

TEST(EdgeModels, ConcaveEdges)
{
  // a box with a cavity that is a box: its edges are concave for the body
  const ClosedSurface hollow =
    vfm::testing::Together(vfm::testing::BoxSurface({ { 1, 1, 1 } }, { { 15, 15, 15 } }),
      vfm::testing::Reversed(
        vfm::testing::BoxSurface({ { 5.1, 5.1, 5.1 } }, { { 11.2, 11.2, 11.2 } })));
  const auto isInside = [](const Vector3& x)
  { return !(x[0] < 11.2 && x[1] < 11.2 && x[2] < 11.2); };
  for (const Vector3& node : { Vector3{ { 11, 11, 8 } }, Vector3{ { 11, 11, 11 } } })
  {
    const auto model = MakeEdgeModel(Around(hollow, node), { { 1, 0, 0 } });
    ASSERT_TRUE(model);
    ExpectSolid(model->Model, node, isInside);
  }
}

TEST(EdgeModels, WallsThinnerThanTheReachHaveBothEdges)
{
  const ClosedSurface wall = vfm::testing::BoxSurface({ { 3, 7.3, 3 } }, { { 13, 8.5, 12.3 } });
  const Vector3 node{ { 8, 8, 12 } };
  const auto model = MakeEdgeModel(Around(wall, node), { { 0, 0, -1 } });
  ASSERT_TRUE(model);
  EXPECT_EQ(model->Model.Count, 3);
  ExpectSolid(
    model->Model, node, [](const Vector3& x) { return x[1] > 7.3 && x[1] < 8.5 && x[2] < 12.3; });
}

/// Between two sides of one sheet, which a smooth part connects, the normals decide.
TEST(EdgeModels, EdgesThatFade)
{
  ClosedSurface box = vfm::testing::BoxSurface(Lower, Upper, 3);
  const Vector3 node{ { 12, 12, 8 } };
  EXPECT_FALSE(MakeEdgeModel(Around(box, node), { { -1, 0, 0 } })->Fades);
  NodeSurroundings around = Around(box, node);
  const std::array<int, 2> sheets = around.Edges[0].Sheets;
  for (NearSample& sample : around.Samples)
  {
    sample.Sheet = sample.Sheet == sheets[1] ? sheets[0] : sample.Sheet;
  }
  for (NearEdge& edge : around.Edges)
  {
    edge.Sheets = { sheets[0], sheets[0] };
  }
  const auto model = MakeEdgeModel(around, { { -1, 0, 0 } });
  ASSERT_TRUE(model);
  EXPECT_TRUE(model->Fades);
  ExpectSolid(model->Model, node, IsInBox);
}

/// A chamfer of 0.02 cells is a sliver between two sides that meet.
TEST(EdgeModels, SliversBetweenSidesAreLeftOut)
{
  const double x = 12.1, y = 12.2, c = 0.02;
  const std::vector<std::array<double, 2>> outline{ { { 3, 3 } }, { { x, 3 } }, { { x, y - c } },
    { { x - c, y } }, { { 3, y } } };
  std::vector<Vector3> points;
  std::vector<PointTriangle> triangles;
  for (const auto& p : outline)
  {
    points.push_back({ { p[0], p[1], 3 } });
    points.push_back({ { p[0], p[1], 13 } });
  }
  for (Index i = 0; i < 5; ++i)
  {
    const Index a = 2 * i, b = 2 * ((i + 1) % 5);
    triangles.push_back({ { a, b, b + 1 } });
    triangles.push_back({ { a, b + 1, a + 1 } });
    if (i > 0 && i < 4)
    {
      triangles.push_back({ { 0, b, a } });
      triangles.push_back({ { 1, a + 1, b + 1 } });
    }
  }
  const Vector3 node{ { 12, 12, 8 } };
  const auto model = MakeEdgeModel(Around(CloseSurface(points, triangles), node), { { -1, 0, 0 } });
  ASSERT_TRUE(model);
  EXPECT_EQ(model->Model.Count, 2);
  ExpectSolid(model->Model, node, IsInBox);
}

} // namespace
