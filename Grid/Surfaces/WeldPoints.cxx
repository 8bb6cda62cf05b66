#include "Surfaces/WeldPoints.h"

#include "Base/BoxTree.h"
#include "Base/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vfm
{
namespace
{

constexpr double CellWidth = 8.0;         // over the distance
constexpr double MostCells = 1 << 20;     // along an axis
constexpr std::size_t MostCompared = 256; // points of a cell

using Cell = std::array<std::int32_t, 3>;

/// Point in a cell of the search.
struct CellPoint
{
  Cell Place;
  Index Point;

  bool operator<(const CellPoint& other) const
  {
    return this->Place != other.Place ? this->Place < other.Place : this->Point < other.Point;
  }
};

/// Cubic cells of the search.
struct CellGrid
{
  Vector3 Lower;
  double Width;

  Cell Find(const Vector3& x) const
  {
    Cell cell{};
    for (int a = 0; a < 3; ++a)
    {
      cell[a] = static_cast<std::int32_t>(std::floor((x[a] - this->Lower[a]) / this->Width));
    }
    return cell;
  }
};

Bounds BoxAround(const std::vector<Vector3>& points)
{
  Bounds box;
  for (const Vector3& x : points)
  {
    box.Add(x);
  }
  return box;
}

/// Calls visit(cell) for the cells behind that of a point, in their order, that are within a
/// distance of the point.
template <class Visitor>
void ForCellsBehind(const CellGrid& grid, const Vector3& x, double distance, const Visitor& visit)
{
  const double reach = 1.001 * distance;
  const Cell here = grid.Find(x), low = grid.Find(x - Vector3{ { reach, reach, reach } }),
             high = grid.Find(x + Vector3{ { reach, reach, reach } });
  for (std::int32_t i = low[0]; i <= high[0]; ++i)
  {
    for (std::int32_t j = low[1]; j <= high[1]; ++j)
    {
      for (std::int32_t k = low[2]; k <= high[2]; ++k)
      {
        const Cell cell{ { i, j, k } };
        if (here < cell)
        {
          visit(cell);
        }
      }
    }
  }
}

} // namespace

double FindDiagonal(const std::vector<Vector3>& points)
{
  const Bounds box = BoxAround(points);
  return points.empty() ? 0.0 : Norm(box.Upper - box.Lower);
}

std::vector<Index> EndsOf(const std::vector<TriangleSide>& edges)
{
  std::vector<Index> ends;
  for (const TriangleSide& edge : edges)
  {
    ends.push_back(edge.Low);
    ends.push_back(edge.High);
  }
  SortUnique(ends);
  return ends;
}

void ForClosePairs(const std::vector<Vector3>& points, const std::vector<Index>& chosen,
  double distance, const std::function<void(Index, Index)>& visit)
{
  const double diagonal = FindDiagonal(points);
  const double width = std::max(CellWidth * distance, diagonal / MostCells);
  if (!(distance > 0.0 && std::isfinite(diagonal) && std::isnormal(width)))
  {
    return;
  }
  const CellGrid grid{ BoxAround(points).Lower, width };
  std::vector<CellPoint> sorted;
  for (Index p : chosen)
  {
    sorted.push_back({ grid.Find(points[p]), p });
  }
  std::sort(sorted.begin(), sorted.end());
  const auto compare = [&](std::size_t one, std::size_t begin, const Cell& cell)
  {
    const std::size_t end = std::min(sorted.size(), begin + MostCompared);
    for (std::size_t other = begin; other < end && sorted[other].Place == cell; ++other)
    {
      const Index a = sorted[one].Point, b = sorted[other].Point;
      if (Norm(points[a] - points[b]) <= distance)
      {
        visit(std::min(a, b), std::max(a, b));
      }
    }
  };
  for (std::size_t one = 0; one < sorted.size(); ++one)
  {
    compare(one, one + 1, sorted[one].Place);
    ForCellsBehind(grid, points[sorted[one].Point], distance,
      [&](const Cell& cell)
      {
        const auto at = std::lower_bound(sorted.begin(), sorted.end(), CellPoint{ cell, 0 });
        compare(one, static_cast<std::size_t>(at - sorted.begin()), cell);
      });
  }
}

Index WeldPoints(double distance, const std::vector<TriangleSide>& open, PatchTriangles& surface)
{
  std::vector<Index> parent = MakeSets(surface.Points.size());
  ForClosePairs(
    surface.Points, EndsOf(open), distance, [&parent](Index a, Index b) { Join(parent, a, b); });
  Index count = 0;
  for (std::size_t p = 0; p < parent.size(); ++p)
  {
    count += FindRoot(parent, static_cast<Index>(p)) != static_cast<Index>(p);
  }
  for (PatchTriangle& triangle : surface.Triangles)
  {
    for (Index& p : triangle.Corners)
    {
      p = FindRoot(parent, p);
    }
  }
  return count;
}

} // namespace vfm
