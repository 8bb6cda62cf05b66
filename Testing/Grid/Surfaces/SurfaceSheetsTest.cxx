/// Sheets and sharp edges of closed surfaces.
#include "Surfaces/SurfaceSheets.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace vfm;

namespace
{

constexpr std::array<PointTriangle, 12> BoxTriangles{ { { { 0, 2, 1 } }, { { 1, 2, 3 } },
  { { 4, 5, 6 } }, { { 5, 7, 6 } }, { { 0, 1, 4 } }, { { 1, 5, 4 } }, { { 2, 6, 3 } },
  { { 3, 6, 7 } }, { { 0, 4, 2 } }, { { 2, 4, 6 } }, { { 1, 3, 5 } }, { { 3, 7, 5 } } } };

/// Adds a box; bit a of the number of a corner is set if it is on the upper side of axis a.
void AddBox(const Vector3& lower, const Vector3& upper, ClosedSurface& surface)
{
  std::array<Index, 8> corners;
  for (int c = 0; c < 8; ++c)
  {
    Vector3 x;
    for (int a = 0; a < 3; ++a)
    {
      x[a] = (c >> a & 1) != 0 ? upper[a] : lower[a];
    }
    const auto at = std::find(surface.Points.begin(), surface.Points.end(), x);
    corners[c] = at - surface.Points.begin();
    if (at == surface.Points.end())
    {
      surface.Points.push_back(x);
    }
  }
  for (const PointTriangle& t : BoxTriangles)
  {
    surface.Triangles.push_back({ { corners[t[0]], corners[t[1]], corners[t[2]] } });
  }
}

int CountSheets(const SurfaceSheets& sheets)
{
  return *std::max_element(sheets.SheetOf.begin(), sheets.SheetOf.end()) + 1;
}

TEST(SurfaceSheets, BoxHasSixSheetsAndTwelveEdges)
{
  ClosedSurface box;
  AddBox({ { 0, 0, 0 } }, { { 1, 2, 3 } }, box);
  const SurfaceSheets sheets = FindSheets(box, 40.0);
  EXPECT_EQ(sheets.SheetOf, (std::vector<int>{ 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5 }));
  EXPECT_EQ(sheets.Edges.size(), 12u);
  ASSERT_EQ(sheets.Corners.size(), 8u);
  EXPECT_EQ(sheets.Corners[3].Point, 3);
  EXPECT_EQ(sheets.Corners[3].Sheets, (std::vector<int>{ 0, 3, 5 }));
  for (const SharpEdge& edge : sheets.Edges)
  {
    EXPECT_TRUE(edge.IsConvex);
    const PointTriangle& first = box.Triangles[edge.Triangles[0]];
    const auto at = std::find(first.begin(), first.end(), edge.Points[0]) - first.begin();
    EXPECT_EQ(first[(at + 1) % 3], edge.Points[1]);
  }
  EXPECT_EQ(CountSheets(FindSheets(box, 95.0)), 1);
}

TEST(SurfaceSheets, EdgesOfACavityAreConcave)
{
  ClosedSurface box;
  AddBox({ { 0, 0, 0 } }, { { 3, 3, 3 } }, box);
  AddBox({ { 1, 1, 1 } }, { { 2, 2, 2 } }, box);
  for (std::size_t t = 12; t < 24; ++t)
  {
    std::swap(box.Triangles[t][1], box.Triangles[t][2]);
  }
  const SurfaceSheets sheets = FindSheets(box, 40.0);
  EXPECT_EQ(CountSheets(sheets), 12);
  ASSERT_EQ(sheets.Edges.size(), 24u);
  EXPECT_EQ(std::count_if(sheets.Edges.begin(), sheets.Edges.end(),
              [](const SharpEdge& edge) { return edge.IsConvex; }),
    12);
}

TEST(SurfaceSheets, NeedlesDoNotCut)
{
  // The upper side of a box has a point 1e-9 off the middle of an edge: a needle that stands
  // upright lies between its two halves. The same needle lies along an edge of the box.
  for (const Vector3& added : { Vector3{ { 0.5, 0.5, 1.0 + 1e-9 } }, Vector3{ { 0.5, 0.0, 1.0 } } })
  {
    ClosedSurface box;
    AddBox({ { 0, 0, 0 } }, { { 1, 1, 1 } }, box);
    const bool isInside = added[1] > 0.0;
    box.Points.push_back(added);
    const PointTriangle cut =
      isInside ? PointTriangle{ { 5, 7, 6 } } : PointTriangle{ { 1, 5, 4 } };
    const Index apex = isInside ? 7 : 1;
    const std::array<Index, 2> ends =
      isInside ? std::array<Index, 2>{ { 6, 5 } } : std::array<Index, 2>{ { 5, 4 } };
    const auto at = std::find(box.Triangles.begin(), box.Triangles.end(), cut);
    ASSERT_NE(at, box.Triangles.end());
    *at = { { ends[0], 8, apex } };
    box.Triangles.push_back({ { 8, ends[1], apex } });
    box.Triangles.push_back({ { 8, ends[0], ends[1] } }); // the needle
    const SurfaceSheets sheets = FindSheets(box, 40.0);
    EXPECT_EQ(CountSheets(sheets), 6);
    EXPECT_EQ(sheets.Normals.back(), (Vector3{ { 0, 0, 1 } }));
    EXPECT_EQ(sheets.Edges.size(), isInside ? 12u : 13u);
  }
}

TEST(SurfaceSheets, BoxesThatTouchAtAnEdgeAreApart)
{
  ClosedSurface boxes;
  AddBox({ { 0, 0, 0 } }, { { 1, 1, 1 } }, boxes);
  AddBox({ { 1, 1, 0 } }, { { 2, 2, 1 } }, boxes);
  ASSERT_EQ(boxes.Points.size(), 14u);
  const SurfaceSheets sheets = FindSheets(boxes, 40.0);
  EXPECT_EQ(CountSheets(sheets), 12);
  EXPECT_EQ(sheets.Edges.size(), 24u);
  for (const SharpEdge& edge : sheets.Edges)
  {
    EXPECT_TRUE(edge.IsConvex);
    EXPECT_EQ(edge.Triangles[0] < 12, edge.Triangles[1] < 12);
  }
}

} // namespace
