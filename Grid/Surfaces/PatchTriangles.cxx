#include "Surfaces/PatchTriangles.h"

#include "Base/Groups.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace vfm
{
namespace
{

/// Point with its number in the input.
struct NumberedPoint
{
  Vector3 Place;
  Index Number;
};

/// Returns the points of triangles in ascending order, possibly repeated.
std::vector<NumberedPoint> SortPoints(
  const std::vector<Vector3>& points, const std::vector<PatchTriangle>& triangles)
{
  std::vector<bool> isUsed(points.size(), false);
  std::vector<NumberedPoint> sorted;
  for (const PatchTriangle& triangle : triangles)
  {
    for (Index p : triangle.Corners)
    {
      if (!isUsed[p])
      {
        isUsed[p] = true;
        const Vector3& x = points[p];
        sorted.push_back({ { { x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 } }, p }); // no -0
      }
    }
  }
  std::sort(sorted.begin(), sorted.end(),
    [](const NumberedPoint& a, const NumberedPoint& b) { return a.Place < b.Place; });
  return sorted;
}

/// Merges equal points. Returns the new number of each point of the input.
std::vector<Index> MergeEqual(
  const std::vector<NumberedPoint>& sorted, std::size_t count, std::vector<Vector3>& merged)
{
  std::vector<Index> numbers(count, -1);
  for (const NumberedPoint& point : sorted)
  {
    if (merged.empty() || merged.back() != point.Place)
    {
      merged.push_back(point.Place);
    }
    numbers[point.Number] = static_cast<Index>(merged.size()) - 1;
  }
  return numbers;
}

/// Keeps the points that triangles use, in their order.
void DropUnused(PatchTriangles& surface)
{
  std::vector<Index> numbers(surface.Points.size(), -1);
  for (const PatchTriangle& triangle : surface.Triangles)
  {
    for (Index p : triangle.Corners)
    {
      numbers[p] = 0;
    }
  }
  Index count = 0;
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    if (numbers[p] == 0)
    {
      numbers[p] = count;
      surface.Points[count++] = surface.Points[p];
    }
  }
  surface.Points.resize(count);
  for (PatchTriangle& triangle : surface.Triangles)
  {
    for (Index& p : triangle.Corners)
    {
      p = numbers[p];
    }
  }
}

bool HasThreeCorners(const PatchTriangle& triangle)
{
  const PointTriangle& c = triangle.Corners;
  return c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
}

bool IsBefore(const PatchTriangle& a, const PatchTriangle& b)
{
  const PointTriangle one = a.Sorted(), other = b.Sorted();
  return one != other              ? one < other
    : a.Corners[1] != b.Corners[1] ? a.Corners[1] < b.Corners[1]
                                   : a.Patch < b.Patch;
}

/// Sorts triangles whose first corner is the lowest.
void SortByCorners(std::size_t points, std::vector<PatchTriangle>& triangles)
{
  Groups<PatchTriangle> groups = MakeGroups<PatchTriangle>(points,
    [&](const auto& visit)
    {
      for (const PatchTriangle& triangle : triangles)
      {
        visit(triangle.Corners[0], triangle);
      }
    });
  for (std::size_t p = 0; p < points; ++p)
  {
    const auto begin = groups.Items.begin();
    std::sort(begin + groups.Begin[p], begin + groups.Begin[p + 1], IsBefore);
  }
  triangles = std::move(groups.Items);
}

} // namespace

PointTriangle PatchTriangle::Sorted() const
{
  PointTriangle sorted = this->Corners;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

PatchTriangles SortTriangles(
  const std::vector<Vector3>& points, std::vector<PatchTriangle> triangles)
{
  PatchTriangles surface;
  const std::vector<Index> numbers =
    MergeEqual(SortPoints(points, triangles), points.size(), surface.Points);
  for (PatchTriangle& triangle : triangles)
  {
    PointTriangle& corners = triangle.Corners;
    corners = { { numbers[corners[0]], numbers[corners[1]], numbers[corners[2]] } };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if (HasThreeCorners(triangle))
    {
      surface.Triangles.push_back(triangle);
    }
  }
  DropUnused(surface);
  SortByCorners(surface.Points.size(), surface.Triangles);
  return surface;
}

std::string FormatPlace(const Vector3& point)
{
  std::string text = "(";
  for (int a = 0; a < 3; ++a)
  {
    char number[32];
    const auto end =
      std::to_chars(number, number + sizeof(number), point[a], std::chars_format::general, 6).ptr;
    text += (a > 0 ? ", " : "") + std::string(number, end);
  }
  return text + ")";
}

} // namespace vfm
