#include "Surfaces/ClosedSurface.h"

#include "Ranks/Errors.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace vfm
{
namespace
{

using Triangles = std::vector<PointTriangle>;

// Largest coordinate of a grid (CartesianGrid); volumes and areas stay in the range of double.
constexpr double LargestCoordinate = 1e60;

void CheckPoints(const std::vector<Vector3>& points, const Triangles& triangles)
{
  const Index count = static_cast<Index>(points.size());
  for (const PointTriangle& triangle : triangles)
  {
    for (Index p : triangle)
    {
      if (p < 0 || p >= count)
      {
        throw InputError("A triangle refers to point " + std::to_string(p) + ", but there are " +
          std::to_string(count) + " points.");
      }
      const Vector3& x = points[p];
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        throw InputError("The point " + std::to_string(p) + " of the surface is not finite.");
      }
      if (std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) }) > LargestCoordinate)
      {
        throw InputError("The point " + std::to_string(p) +
          " of the surface has a coordinate beyond 1e60. Scale the coordinates: use another unit "
          "of length.");
      }
    }
  }
}

/// Replaces points at one place by the first of them. Only points of triangles are compared,
/// because others need not be finite.
void MergePoints(const std::vector<Vector3>& points, Triangles& triangles)
{
  std::vector<Index> order, first(points.size(), -1);
  for (const PointTriangle& triangle : triangles)
  {
    for (Index p : triangle)
    {
      if (first[p] < 0)
      {
        first[p] = p;
        order.push_back(p);
      }
    }
  }
  std::sort(order.begin(), order.end(),
    [&points](Index a, Index b) { return points[a] != points[b] ? points[a] < points[b] : a < b; });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isSame = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = isSame ? first[order[i - 1]] : order[i];
  }
  for (PointTriangle& triangle : triangles)
  {
    for (Index& p : triangle)
    {
      p = first[p];
    }
  }
}

void DropCollapsed(Triangles& triangles)
{
  triangles.erase(
    std::remove_if(triangles.begin(), triangles.end(),
      [](const PointTriangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
    triangles.end());
}

/// Edge of a triangle. Sorting brings equal edges together.
struct TriangleEdge
{
  Index Low, High; // points
  Index Triangle;
  bool IsForward; // from Low to High

  bool Meets(const TriangleEdge& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
};

std::vector<TriangleEdge> SortSides(const Triangles& triangles)
{
  std::vector<TriangleEdge> sides;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      sides.push_back({ std::min(from, to), std::max(from, to), static_cast<Index>(t), from < to });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const TriangleEdge& a, const TriangleEdge& b)
    {
      return std::array<Index, 3>{ { a.Low, a.High, a.Triangle } } <
        std::array<Index, 3>{ { b.Low, b.High, b.Triangle } };
    });
  return sides;
}

/// Checks that each edge has exactly two sides, which follow each other in the sorted list.
void CheckClosed(const std::vector<TriangleEdge>& sides)
{
  if (sides.empty())
  {
    throw InputError("The surface has no polygons.");
  }
  Index open = 0, shared = 0;
  for (std::size_t begin = 0, end; begin < sides.size(); begin = end)
  {
    for (end = begin + 1; end < sides.size() && sides[begin].Meets(sides[end]);)
    {
      ++end;
    }
    open += end - begin == 1;
    shared += end - begin > 2;
  }
  if (open > 0)
  {
    throw InputError("The surface is open: " + std::to_string(open) +
      " edges belong to one triangle only. Close its holes first (ParaView's filter Fill Holes).");
  }
  if (shared > 0)
  {
    throw InputError("The surface is not manifold: " + std::to_string(shared) +
      " edges belong to more than two triangles. Separate its parts first.");
  }
}

/// Triangle on the other side of an edge, and whether both triangles face the same way.
struct Neighbour
{
  Index Triangle;
  bool IsSameTurn;
};

/// Returns three neighbours per triangle.
std::vector<Neighbour> FindNeighbours(const std::vector<TriangleEdge>& sides)
{
  std::vector<Neighbour> neighbours(sides.size());
  std::vector<int> count(sides.size() / 3, 0);
  const auto add = [&](const TriangleEdge& side, const TriangleEdge& other)
  {
    neighbours[3 * side.Triangle + count[side.Triangle]++] = { other.Triangle,
      side.IsForward != other.IsForward };
  };
  for (std::size_t s = 0; s < sides.size(); s += 2)
  {
    add(sides[s], sides[s + 1]);
    add(sides[s + 1], sides[s]);
  }
  return neighbours;
}

/// Orients the triangles of each connected component like its first triangle.
void OrientConsistently(const std::vector<Neighbour>& neighbours, Triangles& triangles)
{
  std::vector<bool> isDone(triangles.size(), false), isTurned(triangles.size(), false);
  std::vector<Index> toDo;
  for (std::size_t first = 0; first < triangles.size(); ++first)
  {
    if (!isDone[first])
    {
      isDone[first] = true;
      toDo.push_back(static_cast<Index>(first));
    }
    while (!toDo.empty())
    {
      const Index t = toDo.back();
      toDo.pop_back();
      for (int i = 0; i < 3; ++i)
      {
        const Neighbour& next = neighbours[3 * t + i];
        if (!isDone[next.Triangle])
        {
          isDone[next.Triangle] = true;
          isTurned[next.Triangle] = isTurned[t] == next.IsSameTurn;
          toDo.push_back(next.Triangle);
        }
      }
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (isTurned[t])
    {
      std::swap(triangles[t][1], triangles[t][2]);
    }
  }
}

} // namespace

std::vector<Triangle> PlaceTriangles(const ClosedSurface& surface)
{
  std::vector<Triangle> placed;
  for (const PointTriangle& t : surface.Triangles)
  {
    placed.push_back({ { surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] } });
  }
  return placed;
}

double MeasureVolume(const ClosedSurface& surface)
{
  const Vector3 origin =
    surface.Triangles.empty() ? Vector3{} : surface.Points[surface.Triangles[0][0]];
  double sum = 0.0;
  for (const Triangle& t : PlaceTriangles(surface))
  {
    sum += Dot(t[0] - origin, Cross(t[1] - origin, t[2] - origin)) / 6.0;
  }
  return sum;
}

ClosedSurface CloseSurface(std::vector<Vector3> points, Triangles triangles)
{
  CheckPoints(points, triangles);
  MergePoints(points, triangles);
  DropCollapsed(triangles);
  const std::vector<TriangleEdge> sides = SortSides(triangles);
  CheckClosed(sides);
  OrientConsistently(FindNeighbours(sides), triangles);
  ClosedSurface surface{ std::move(points), std::move(triangles) };
  if (MeasureVolume(surface) < 0.0)
  {
    for (PointTriangle& triangle : surface.Triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return surface;
}

} // namespace vfm
