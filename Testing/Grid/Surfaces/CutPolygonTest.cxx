/// Parts of triangles between planes.
#include "Surfaces/CutPolygon.h"

#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

CutPolygon TriangleOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  CutPolygon polygon;
  polygon.Size = 3;
  polygon.Corners[0] = a;
  polygon.Corners[1] = b;
  polygon.Corners[2] = c;
  return polygon;
}

Vector3 AreaOf(const CutPolygon& polygon)
{
  Vector3 area{ { 0, 0, 0 } };
  for (int i = 1; i + 1 < polygon.Size; ++i)
  {
    area = area +
      0.5 *
        Cross(polygon.Corners[i] - polygon.Corners[0], polygon.Corners[i + 1] - polygon.Corners[0]);
  }
  return area;
}

/// Returns the corners at a coordinate.
std::vector<Vector3> CornersAt(const CutPolygon& polygon, int axis, double value)
{
  std::vector<Vector3> corners;
  for (int i = 0; i < polygon.Size; ++i)
  {
    if (polygon.Corners[i][axis] == value)
    {
      corners.push_back(polygon.Corners[i]);
    }
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

} // namespace

TEST(CutPolygon, PartsCoverThePolygonAndShareTheirCorners)
{
  RandomDraw draw(2);
  for (int i = 0; i < 1000; ++i)
  {
    const CutPolygon triangle =
      TriangleOf(draw.Vector(-1, 1), draw.Vector(-1, 1), draw.Vector(-1, 1));
    const int axis = i % 3;
    const CutPolygon low = CutBetween(triangle, axis, { -2.0, -0.2 });
    const CutPolygon middle = CutBetween(triangle, axis, { -0.2, 0.3 });
    const CutPolygon high = CutBetween(triangle, axis, { 0.3, 2.0 });
    EXPECT_LT(Norm(AreaOf(low) + AreaOf(middle) + AreaOf(high) - AreaOf(triangle)), 1e-14);
    EXPECT_EQ(CornersAt(low, axis, -0.2), CornersAt(middle, axis, -0.2));
    EXPECT_EQ(CornersAt(middle, axis, 0.3), CornersAt(high, axis, 0.3));
    EXPECT_TRUE(
      middle.Size == 0 || (middle.Extent(axis).Low >= -0.2 && middle.Extent(axis).High <= 0.3));
  }
}

TEST(CutPolygon, CutsDependOnlyOnTheEdge)
{
  RandomDraw draw(4);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 a = draw.Vector(-1.0, -0.1), b = draw.Vector(0.1, 1.0);
    const double value = draw.Between(-0.1, 0.1);
    const CutPolygon one = CutBetween(TriangleOf(a, b, draw.Vector(0.1, 1.0)), 1, { value, 2.0 });
    const CutPolygon other =
      CutBetween(TriangleOf(b, a, draw.Vector(-1.0, -0.1)), 1, { -2.0, value });
    const std::vector<Vector3> first = CornersAt(one, 1, value),
                               second = CornersAt(other, 1, value);
    EXPECT_EQ(first.size(), 2u);
    EXPECT_TRUE(
      std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) != first.end());
  }
}

/// Rounding moves corners across planes if a triangle is much larger than the range, so that its
/// part has more corners than a convex polygon.
TEST(CutPolygon, LargeTriangles)
{
  CutPolygon part = TriangleOf({ { 3, 1, 0 } },
    { { 432345564227567620.0, 180143985094819840.0, 324259173170675710.0 } }, { { 6, 7, 11 } });
  const Interval ranges[3] = { { 5, 12 }, { 4, 11 }, { 7, 10 } };
  for (int axis : { 2, 1, 0 })
  {
    part = CutBetween(part, axis, ranges[axis]);
    ASSERT_GT(part.Size, 2);
    EXPECT_GE(part.Extent(axis).Low, ranges[axis].Low);
    EXPECT_LE(part.Extent(axis).High, ranges[axis].High);
  }
}
