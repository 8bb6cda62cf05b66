/// Closed surfaces from the triangles of files.
#include "Surfaces/ClosedSurface.h"

#include "Ranks/Errors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;

namespace
{

TEST(ClosedSurface, PointsWithoutTrianglesNeedNotBeFinite)
{
  std::vector<Vector3> points{ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  std::vector<PointTriangle> triangles;
  for (Index i = 0; i < 200; ++i) // copies of the corners, and points that are not used
  {
    const Index first = static_cast<Index>(points.size());
    points.push_back({ { NAN, static_cast<double>(i % 7), NAN } });
    points.push_back(points[i % 4]);
    triangles.push_back({ { i % 4, first + 1, i % 4 } });
  }
  for (const PointTriangle& triangle : { PointTriangle{ { 0, 2, 1 } }, PointTriangle{ { 0, 1, 3 } },
         PointTriangle{ { 1, 2, 3 } }, PointTriangle{ { 0, 3, 2 } } })
  {
    triangles.push_back(triangle);
  }
  EXPECT_EQ(CloseSurface(points, triangles).Triangles.size(), 4u);
}

} // namespace
