/// Surfaces of bodies in grid coordinates.
#include "GivenSurfaces/BodySurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace vfm;

namespace
{

BodySurface MakeTet(const std::string& name, double scale)
{
  const std::vector<Vector3> points{ { { 2, 2, 2 } }, { { 2 + scale, 2, 2 } },
    { { 2, 2 + scale, 2 } }, { { 2, 2, 2 + scale } } };
  return MakeBody(name, points,
    { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 0, 3, 2 } } }, { 0, 0, 1, 1 },
    { "base", "slope" });
}

const std::vector<double> Coordinates{ 1, 3, 5, 7 };
const CartesianGrid Grid(
  std::array<std::vector<double>, 3>{ Coordinates, Coordinates, Coordinates });

TEST(BodySurfaces, MaterialsAreFoundByName)
{
  const InputSurfaces input{ { MakeTet("b", 1.0), MakeTet("none", 2.0), MakeTet("a", 3.0) } };
  const BodySurfaces surfaces(input, { "a", "c", "b" }, Grid, 40.0);
  ASSERT_EQ(surfaces.Bodies().size(), 2u);
  EXPECT_EQ(surfaces.Bodies()[0].Material, 3);
  EXPECT_EQ(surfaces.Bodies()[1].Material, 1);
  EXPECT_EQ(surfaces.Find(0), -1);
  EXPECT_EQ(surfaces.Find(2), -1);
  EXPECT_EQ(surfaces.FindOfInterface(0, 1), 1);
  EXPECT_EQ(surfaces.FindOfInterface(1, 3), 0);
  EXPECT_EQ(surfaces.FindOfInterface(2, 3), 0);
  EXPECT_EQ(surfaces.FindOfInterface(0, 2), -1);
  EXPECT_EQ(surfaces.Periods(), (Vector3{ { 0, 0, 0 } }));
}

TEST(BodySurfaces, GridCoordinatesCountCells)
{
  const BodySurfaces surfaces({ { MakeTet("a", 2.0) } }, { "a" }, Grid, 40.0);
  const GivenBody& body = surfaces.Bodies()[0];
  const std::vector<Vector3>& points = body.Boundary.Points;
  EXPECT_EQ(points.front(), (Vector3{ { 0.5, 0.5, 0.5 } })); // the lowest one
  EXPECT_EQ(points.back(), (Vector3{ { 1.5, 0.5, 0.5 } }));
  EXPECT_EQ(std::count(body.Sides.SideOf.begin(), body.Sides.SideOf.end(), 1), 2);
  EXPECT_EQ(body.Sides.Names, (std::vector<std::string>{ "base", "slope" }));
  EXPECT_EQ(body.Sheets.Edges.size(), 6u);
}

TEST(BodySurfaces, MirroredAxesKeepSurfacesOutwards)
{
  const auto mirror = [](const Vector3& x) { return Vector3{ { 8.0 - x[0], x[1], x[2] } }; };
  const BodySurfaces surfaces({ { MakeTet("a", 2.0) } }, { "a" }, Grid, 40.0, mirror);
  const GivenBody& body = surfaces.Bodies()[0];
  EXPECT_EQ(body.Boundary.Points[0], (Vector3{ { 2.5, 0.5, 0.5 } }));
  EXPECT_NEAR(MeasureVolume(body.Boundary), 1.0 / 6.0, 1e-15);
}

TEST(BodySurfaces, PeriodsAreInCells)
{
  const CartesianGrid periodic = CartesianGrid::Covering(
    Grid.Coordinates(), Grid.Owned(), { { true, false, false } }, Seam::Free, GhostLayers);
  const BodySurfaces surfaces({ { MakeTet("a", 2.0) } }, { "a" }, periodic, 40.0);
  EXPECT_EQ(surfaces.Periods(), (Vector3{ { 3, 0, 0 } }));
  const double below = static_cast<double>(periodic.Domain().Lower[0]);
  EXPECT_EQ(surfaces.Domain().Lower, (Vector3{ { below, 0, 0 } }));
  EXPECT_EQ(surfaces.Domain().Upper, (Vector3{ { below + 3, 3, 3 } }));
  EXPECT_EQ(surfaces.Bodies()[0].Boundary.Points[0], (Vector3{ { below + 0.5, 0.5, 0.5 } }));
}

} // namespace
