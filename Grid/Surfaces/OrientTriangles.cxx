#include "Surfaces/OrientTriangles.h"

#include "Base/DisjointSets.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfm
{
namespace
{

constexpr double SameAngle = 1e-6; // around an edge; 4 for a whole turn

/// Triangle on the other side of an edge of two triangles, and whether both face the same way.
struct Neighbour
{
  Index Triangle = -1;
  bool IsSameTurn = false;
};

/// Triangle at an edge, by its angle.
struct TriangleAtEdge
{
  double Angle; // from 0 to 4, ascending as the angle does
  Index Triangle;
  bool IsForward;
};

/// Returns up to three neighbours per triangle.
std::vector<Neighbour> FindNeighbours(const std::vector<TriangleSide>& sides)
{
  std::vector<Neighbour> neighbours(sides.size());
  std::vector<signed char> count(sides.size() / 3, 0);
  const auto add = [&](const TriangleSide& side, const TriangleSide& other)
  {
    neighbours[3 * side.Triangle + count[side.Triangle]++] = { other.Triangle,
      side.IsForward != other.IsForward };
  };
  ForEdges(sides,
    [&](auto first, auto last)
    {
      if (last - first == 2)
      {
        add(*first, *(first + 1));
        add(*(first + 1), *first);
      }
    });
  return neighbours;
}

/// Finds the components that are joined by edges of two triangles.
SurfaceParts FindSheets(const PatchTriangles& surface, const std::vector<Neighbour>& neighbours)
{
  const std::size_t count = surface.Triangles.size();
  SurfaceParts sheets{ std::vector<Index>(count, -1), std::vector<bool>(count, false), 0 };
  std::vector<Index> toDo;
  for (std::size_t first = 0; first < count; ++first)
  {
    if (sheets.Part[first] < 0)
    {
      sheets.Part[first] = sheets.Count++;
      toDo.push_back(static_cast<Index>(first));
    }
    while (!toDo.empty())
    {
      const Index t = toDo.back();
      toDo.pop_back();
      for (int i = 0; i < 3 && neighbours[3 * t + i].Triangle >= 0; ++i)
      {
        const Neighbour& next = neighbours[3 * t + i];
        const bool isTurned = sheets.IsTurned[t] == next.IsSameTurn;
        if (sheets.Part[next.Triangle] < 0)
        {
          sheets.Part[next.Triangle] = sheets.Part[t];
          sheets.IsTurned[next.Triangle] = isTurned;
          toDo.push_back(next.Triangle);
        }
        else if (sheets.IsTurned[next.Triangle] != isTurned)
        {
          throw InputError("The surface has only one side, as a Moebius strip has, at " +
            FormatPlace(surface.Points[surface.Triangles[next.Triangle].Corners[0]]) + ".");
        }
      }
    }
  }
  return sheets;
}

/// Returns a number from 0 to 4 that ascends as the angle of a direction.
double MeasureTurn(double x, double y)
{
  const double sum = std::fabs(x) + std::fabs(y);
  const double part = sum > 0.0 ? x / sum : 1.0;
  return y >= 0.0 ? 1.0 - part : 3.0 + part;
}

/// Returns the triangles at an edge, ascending by angle.
std::vector<TriangleAtEdge> SortAround(const PatchTriangles& surface,
  std::vector<TriangleSide>::const_iterator first, std::vector<TriangleSide>::const_iterator last)
{
  const Vector3& origin = surface.Points[first->Low];
  Vector3 u, v;
  MakeTangents(Unit(surface.Points[first->High] - origin), u, v);
  std::vector<TriangleAtEdge> around;
  for (auto side = first; side != last; ++side)
  {
    const PointTriangle& c = surface.Triangles[side->Triangle].Corners;
    const Vector3 to = surface.Points[c[0] + c[1] + c[2] - side->Low - side->High] - origin;
    around.push_back({ MeasureTurn(Dot(to, u), Dot(to, v)), side->Triangle, side->IsForward });
  }
  std::sort(around.begin(), around.end(),
    [](const TriangleAtEdge& a, const TriangleAtEdge& b)
    { return a.Angle != b.Angle ? a.Angle < b.Angle : a.Triangle < b.Triangle; });
  return around;
}

/// Sets with a turn of each item against the root of its set.
class TurnedSets
{
public:
  explicit TurnedSets(std::size_t count) : Parent(MakeSets(count)), IsTurned(count, false) {}

  /// Returns the root of an item, and whether the item is turned against it.
  std::pair<Index, bool> Find(Index item)
  {
    bool isTurned = false;
    while (this->Parent[item] != item)
    {
      const Index next = this->Parent[item]; // shortens the path
      this->IsTurned[item] = this->IsTurned[item] != this->IsTurned[next];
      this->Parent[item] = this->Parent[next];
      isTurned = isTurned != this->IsTurned[item];
      item = this->Parent[item];
    }
    return { item, isTurned };
  }
  /// Joins two sets; items that are joined already stay as they are.
  void Join(Index a, Index b, bool areOpposite)
  {
    const auto [rootA, turnA] = this->Find(a);
    const auto [rootB, turnB] = this->Find(b);
    const Index low = std::min(rootA, rootB), high = std::max(rootA, rootB);
    if (low != high)
    {
      this->Parent[high] = low;
      this->IsTurned[high] = (turnA != turnB) != areOpposite;
    }
  }

private:
  std::vector<Index> Parent;
  std::vector<bool> IsTurned;
};

/// Pair of triangles that follow each other around an edge.
struct EdgePair
{
  Index A, B;
  bool AreOpposite; ///< one of their sheets must be turned
  bool IsClear;     ///< they are at different angles
};

/// Returns the pairs at all edges of more than two triangles.
std::vector<EdgePair> FindPairs(
  const PatchTriangles& surface, const std::vector<TriangleSide>& sides, const SurfaceParts& sheets)
{
  std::vector<EdgePair> pairs;
  ForEdges(sides,
    [&](auto first, auto last)
    {
      if (last - first <= 2)
      {
        return;
      }
      const std::vector<TriangleAtEdge> around = SortAround(surface, first, last);
      for (std::size_t i = 0; i < around.size(); ++i)
      {
        const TriangleAtEdge &a = around[i], &b = around[(i + 1) % around.size()];
        const bool turnA = a.IsForward != sheets.IsTurned[a.Triangle];
        const bool turnB = b.IsForward != sheets.IsTurned[b.Triangle];
        const double gap = b.Angle - a.Angle + (i + 1 == around.size() ? 4.0 : 0.0);
        pairs.push_back({ sheets.Part[a.Triangle], sheets.Part[b.Triangle], turnA == turnB,
          gap > SameAngle && gap < 4.0 - SameAngle });
      }
    });
  return pairs;
}

} // namespace

SurfaceParts FindParts(const PatchTriangles& surface, const std::vector<TriangleSide>& sides)
{
  SurfaceParts parts = FindSheets(surface, FindNeighbours(sides));
  const std::vector<EdgePair> pairs = FindPairs(surface, sides, parts);
  TurnedSets sets(static_cast<std::size_t>(parts.Count));
  for (bool isClear : { true, false })
  {
    for (const EdgePair& pair : pairs)
    {
      if (pair.IsClear == isClear)
      {
        sets.Join(pair.A, pair.B, pair.AreOpposite);
      }
    }
  }
  std::vector<Index> numbers(parts.Count, -1);
  Index count = 0;
  for (std::size_t t = 0; t < parts.Part.size(); ++t)
  {
    const auto [root, isTurned] = sets.Find(parts.Part[t]);
    numbers[root] = numbers[root] < 0 ? count++ : numbers[root];
    parts.Part[t] = numbers[root];
    parts.IsTurned[t] = parts.IsTurned[t] != isTurned;
  }
  parts.Count = count;
  return parts;
}

} // namespace vfm
