#include "Surfaces/SplitEdges.h"

#include "Base/BoxTree.h"
#include "Surfaces/WeldPoints.h"

#include <algorithm>
#include <map>

namespace vfm
{
namespace
{

constexpr int MostRounds = 4; // each divides one edge of a triangle

/// Point on an edge, from 0 at its lower end to 1.
struct PointOnEdge
{
  double Place;
  Index Point;

  bool operator<(const PointOnEdge& other) const
  {
    return this->Place != other.Place ? this->Place < other.Place : this->Point < other.Point;
  }
};

/// Returns the place of a point on an edge, or a negative number if it is not on it.
double FindPlace(
  const std::vector<Vector3>& points, const TriangleSide& edge, Index point, double distance)
{
  const Vector3 along = points[edge.High] - points[edge.Low];
  const Vector3 to = points[point] - points[edge.Low];
  const double place = Dot(to, along) / Dot(along, along);
  const bool isInside = place > 0.0 && place < 1.0;
  return isInside && Norm(to - place * along) <= distance ? place : -1.0;
}

bool IsCorner(const PatchTriangle& triangle, Index point)
{
  const PointTriangle& c = triangle.Corners;
  return point == c[0] || point == c[1] || point == c[2];
}

/// Returns the points on each open edge that are not corners of its triangle.
std::vector<std::vector<PointOnEdge>> FindPointsOnEdges(
  double distance, const PatchTriangles& surface, const std::vector<TriangleSide>& open)
{
  const std::vector<Vector3>& points = surface.Points;
  const Index edges = static_cast<Index>(open.size());
  const std::vector<Index> ends = EndsOf(open);
  std::vector<Bounds> boxes(open.size() + ends.size());
  for (std::size_t e = 0; e < open.size(); ++e)
  {
    const Vector3 reach{ { distance, distance, distance } };
    for (Index p : { open[e].Low, open[e].High })
    {
      boxes[e].Add(points[p] - reach);
      boxes[e].Add(points[p] + reach);
    }
  }
  for (std::size_t v = 0; v < ends.size(); ++v)
  {
    boxes[open.size() + v].Add(points[ends[v]]);
  }
  std::vector<std::vector<PointOnEdge>> found(open.size());
  Runtime serial;
  BoxTree(boxes, serial)
    .ForPairs(serial,
      [&](Index one, Index other)
      {
        const auto [edge, end] = std::minmax(one, other);
        if (edge < edges && end >= edges)
        {
          const Index point = ends[end - edges];
          const double place = FindPlace(points, open[edge], point, distance);
          if (place > 0.0 && !IsCorner(surface.Triangles[open[edge].Triangle], point))
          {
            found[edge].push_back({ place, point });
          }
        }
      });
  return found;
}

/// Divides a triangle at points on one of its sides.
void Divide(const PatchTriangle& triangle, const TriangleSide& side,
  const std::vector<PointOnEdge>& onSide, std::vector<PatchTriangle>& parts)
{
  const auto& c = triangle.Corners;
  const Index across = c[0] + c[1] + c[2] - side.Low - side.High;
  Index before = side.Low;
  const auto add = [&](Index point)
  {
    parts.push_back({ { { before, point, across } }, triangle.Patch });
    if (!side.IsForward)
    {
      parts.back().Turn();
    }
    before = point;
  };
  for (const PointOnEdge& point : onSide)
  {
    add(point.Point);
  }
  add(side.High);
}

/// Divides each triangle at one of its sides. Returns the number of divided triangles.
Index SplitOnce(double distance, PatchTriangles& surface)
{
  const std::vector<TriangleSide> open = FindOddEdges(SortSides(surface));
  std::vector<std::vector<PointOnEdge>> onEdges = FindPointsOnEdges(distance, surface, open);
  std::map<Index, std::size_t> edges; // to divide, by triangle
  for (std::size_t e = 0; e < open.size(); ++e)
  {
    if (!onEdges[e].empty())
    {
      std::sort(onEdges[e].begin(), onEdges[e].end());
      edges.emplace(open[e].Triangle, e);
    }
  }
  if (edges.empty())
  {
    return 0;
  }
  std::vector<PatchTriangle> parts;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const auto edge = edges.find(static_cast<Index>(t));
    if (edge == edges.end())
    {
      parts.push_back(surface.Triangles[t]);
    }
    else
    {
      Divide(surface.Triangles[t], open[edge->second], onEdges[edge->second], parts);
    }
  }
  surface = SortTriangles(surface.Points, std::move(parts));
  return static_cast<Index>(edges.size());
}

} // namespace

Index SplitOpenEdges(double distance, PatchTriangles& surface)
{
  Index count = 0, round = 0;
  for (int r = 0; r < MostRounds && (r == 0 || round > 0); ++r)
  {
    round = SplitOnce(distance, surface);
    count += round;
  }
  return count;
}

} // namespace vfm
