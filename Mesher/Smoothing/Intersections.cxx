#include "Smoothing/Intersections.h"

#include "Base/BoxTree.h"
#include "Base/Vector3.h"
#include "Ranks/FindMeetings.h"

#include <cmath>
#include <limits>

namespace vfm
{
namespace
{

constexpr double Touching = 1e-13; // overlap of projections that is rounding, in facet widths
constexpr double FarAway = 1e15;   // beyond all points, grid coordinates

using Triangle = std::array<Vector3, 3>;

/// A facet with its points in their current positions.
struct Shape
{
  std::array<Vector3, 4> X; // of a triangle: the last one twice
  /// Points of the mesh; negative: points of other ranks without a facet here.
  std::array<Index, 4> Points;

  int Corners() const { return CornersOf(this->Points); }
};

/// A facet as it is sent to other ranks. Start positions identify points on all ranks.
struct SentFacet
{
  std::array<Vector3, 4> X, Start;
};

Vector3 MeanOf(const std::array<Vector3, 4>& x)
{
  return 0.25 * ((x[0] + x[1]) + (x[2] + x[3]));
}

Bounds BoundsOf(const std::array<Vector3, 4>& x)
{
  Bounds box;
  for (const Vector3& corner : x)
  {
    box.Add(corner);
  }
  return box;
}

/// Common corners of two facets.
struct Common
{
  int OfA = 0, OfB = 0; // bit c is set for corner c
  int Count = 0;
  Vector3 First{}, Last{};
};

Common FindCommon(const Shape& a, const Shape& b)
{
  Common common;
  for (int i = 0; i < 4; ++i)
  {
    int equal = 0; // corners of b
    for (int j = 0; j < 4; ++j)
    {
      equal |= (a.Points[i] == b.Points[j]) << j;
    }
    common.OfB |= equal;
    if (equal != 0)
    {
      common.OfA |= 1 << i;
      const bool isNew = i < a.Corners();
      common.Count += isNew;
      (common.Count == 1 ? common.First : common.Last) = a.X[i];
    }
  }
  return common;
}

/// Returns whether a plane separates two facets, which may only touch it in a common corner or
/// edge. Tests one plane, which separates nearly all facets that do not intersect.
bool AreSeparated(const Shape& a, const Shape& b)
{
  const Common common = FindCommon(a, b);
  if (common.Count > 2)
  {
    return false;
  }
  const Vector3 origin = common.Count == 0 ? MeanOf(b.X) : common.First;
  Vector3 normal = MeanOf(a.X) - MeanOf(b.X);
  if (common.Count == 2)
  {
    const Vector3 edge = common.Last - common.First;
    normal = normal - (Dot(normal, edge) / Dot(edge, edge)) * edge;
  }
  double lowest = 1e300, highest = -1e300; // of a and b
  for (int c = 0; c < 4; ++c)
  {
    const double ofA = Dot(normal, a.X[c] - origin), ofB = Dot(normal, b.X[c] - origin);
    lowest = common.OfA >> c & 1 ? lowest : std::min(lowest, ofA);
    highest = common.OfB >> c & 1 ? highest : std::max(highest, ofB);
  }
  return common.Count == 0 ? lowest > highest : lowest > 0.0 && highest < 0.0;
}

/// Returns the common length of the projections of two triangles on an axis of length 1.
double ProjectedOverlap(const Triangle& a, const Triangle& b, const Vector3& axis)
{
  const auto project = [&](const Triangle& triangle)
  {
    const double x[3] = { Dot(axis, triangle[0] - a[0]), Dot(axis, triangle[1] - a[0]),
      Dot(axis, triangle[2] - a[0]) };
    return std::minmax({ x[0], x[1], x[2] });
  };
  const auto ofA = project(a), ofB = project(b);
  return std::min(ofA.second - ofB.first, ofB.second - ofA.first);
}

/// Returns whether triangles intersect: no plane parallel to one of them, or to an edge of each,
/// separates them.
bool DoIntersect(const Triangle& a, const Triangle& b)
{
  const std::array<Vector3, 3> ofA{ { a[1] - a[0], a[2] - a[1], a[0] - a[2] } },
    ofB{ { b[1] - b[0], b[2] - b[1], b[0] - b[2] } };
  const double touching = Touching * std::max(Norm(ofA[0]), Norm(ofB[0]));
  const auto separates = [&](const Vector3& axis)
  {
    const double length = Norm(axis);
    return length > 1e-200 && ProjectedOverlap(a, b, (1.0 / length) * axis) <= touching;
  };
  bool areApart = separates(Cross(ofA[0], ofA[1])) || separates(Cross(ofB[0], ofB[1]));
  for (int e = 0; e < 9 && !areApart; ++e)
  {
    areApart = separates(Cross(ofA[e / 3], ofB[e % 3]));
  }
  return !areApart;
}

/// Calls visit(triangle) for the triangles of a facet until it returns true; returns whether it
/// did.
template <class Visitor>
bool AnyTriangle(const Shape& shape, const Visitor& visit)
{
  if (shape.Corners() == 3)
  {
    return visit(Triangle{ { shape.X[0], shape.X[1], shape.X[2] } });
  }
  const Vector3 middle = MeanOf(shape.X);
  bool found = false;
  for (int c = 0; c < 4 && !found; ++c)
  {
    found = visit(Triangle{ { shape.X[c], shape.X[(c + 1) % 4], middle } });
  }
  return found;
}

/// Returns whether different corners of two facets are at the same place.
bool Coincide(const Shape& a, const Shape& b)
{
  bool coincide = false;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      coincide = coincide || (a.Points[i] != b.Points[j] && a.X[i] == b.X[j]);
    }
  }
  return coincide;
}

/// Returns whether two facets intersect, whichever is the first.
bool DoIntersect(const Shape& one, const Shape& other)
{
  if (AreSeparated(one, other))
  {
    return false;
  }
  const Shape &a = one.X < other.X ? one : other, &b = one.X < other.X ? other : one;
  return Coincide(a, b) ||
    AnyTriangle(a,
      [&](const Triangle& first) {
        return AnyTriangle(b, [&](const Triangle& second) { return DoIntersect(first, second); });
      });
}

/// The facets next to void that is not meshed, of this rank and those near it of other ranks.
class FreeFacets
{
public:
  FreeFacets(const ActiveMesh& mesh, Ranks& ranks) : Mesh(mesh)
  {
    const auto isFree = [](const ActiveFacet& facet)
    { return facet.Fragments[0] == 0 || facet.Fragments[1] == 0; };
    const Index count = std::count_if(mesh.Facets.begin(), mesh.Facets.end(), isFree);
    this->Own.reserve(count);
    this->Boxes.reserve(count);
    for (const ActiveFacet& facet : mesh.Facets)
    {
      if (isFree(facet))
      {
        this->Own.push_back(&facet);
        this->Boxes.push_back(BoundsOf(this->OwnAt(this->Own.size() - 1).X));
      }
    }
    if (ranks.Count() > 1)
    {
      this->Exchange(ranks);
    }
  }

  /// Returns the number of facets of this rank; they are the first ones.
  Index CountOwn() const { return static_cast<Index>(this->Own.size()); }
  /// Returns the bounds of all facets; they are not kept.
  std::vector<Bounds> TakeBounds() { return std::move(this->Boxes); }
  Shape At(Index facet) const
  {
    return facet < this->CountOwn() ? this->OwnAt(facet) : this->Received[facet - this->CountOwn()];
  }

private:
  Shape OwnAt(Index facet) const
  {
    Shape shape;
    for (int c = 0; c < 4; ++c)
    {
      shape.Points[c] = this->Own[facet]->Points[c];
      shape.X[c] = this->Mesh.X[shape.Points[c]];
    }
    return shape;
  }
  void Exchange(Ranks& ranks);
  void Add(const std::vector<SentFacet>& facets, const std::vector<Index>& sent);

  const ActiveMesh& Mesh;
  std::vector<const ActiveFacet*> Own;
  std::vector<Shape> Received;
  std::vector<Bounds> Boxes;
};

/// Returns the cells of a grid of unit width that a box touches.
IndexBox CellsOf(const Bounds& box)
{
  const auto cellOf = [](double x)
  { return static_cast<Index>(std::floor(std::clamp(x, -FarAway, FarAway))); };
  IndexBox cells;
  for (int a = 0; a < 3; ++a)
  {
    cells.Lower[a] = cellOf(box.Lower[a]);
    cells.Upper[a] = cellOf(box.Upper[a]) + 1;
  }
  return cells;
}

/// Returns the bounds of the facets of the ranks whose facets may touch those of this rank, ordered
/// by rank.
/// @param own  bounds of the facets of this rank
/// Collective.
std::vector<RankItem<Bounds>> FindRanksNear(const Bounds& own, Ranks& ranks)
{
  const bool isEmpty = own.Lower[0] > own.Upper[0];
  return FindMeetings(
    std::vector<Bounds>(isEmpty ? 0 : 1, own),
    [](const Bounds& box) { return std::array<IndexBox, 1>{ { CellsOf(box) } }; },
    [](const Bounds& a, const Bounds& b) { return a.Touches(b); }, ranks);
}

/// Sends facets to the ranks whose facets may touch them.
void FreeFacets::Exchange(Ranks& ranks)
{
  Bounds own;
  for (const Bounds& box : this->Boxes)
  {
    own.Add(box);
  }
  std::vector<int> peers;
  std::vector<std::vector<SentFacet>> lists;
  std::vector<Index> sent;
  for (const RankItem<Bounds>& near : FindRanksNear(own, ranks))
  {
    peers.push_back(near.Rank);
    lists.emplace_back();
    for (Index f = 0; f < this->CountOwn(); ++f)
    {
      if (!this->Boxes[f].Touches(near.What))
      {
        continue;
      }
      sent.push_back(f);
      const Shape shape = this->OwnAt(f);
      lists.back().push_back({ shape.X, {} });
      for (int c = 0; c < 4; ++c)
      {
        lists.back().back().Start[c] = this->Mesh.StartOf(static_cast<int>(shape.Points[c]));
      }
    }
  }
  this->Add(ExchangeItems(ranks, peers, lists), sent);
}

/// Adds facets of other ranks. Their common points with facets of this rank are among the points
/// of the facets that this rank has sent.
void FreeFacets::Add(const std::vector<SentFacet>& facets, const std::vector<Index>& sent)
{
  std::vector<std::pair<Vector3, Index>> known; // start and point
  for (Index f : sent)
  {
    for (Index point : this->Own[f]->Points)
    {
      known.emplace_back(this->Mesh.StartOf(static_cast<int>(point)), point);
    }
  }
  std::sort(known.begin(), known.end());
  Index unknown = -1;
  for (const SentFacet& facet : facets)
  {
    Shape shape{ facet.X, {} };
    for (int c = 0; c < 4; ++c)
    {
      const auto at = std::lower_bound(known.begin(), known.end(),
        std::make_pair(facet.Start[c], std::numeric_limits<Index>::min()));
      shape.Points[c] = at != known.end() && at->first == facet.Start[c] ? at->second
        : c > 0 && facet.Start[c] == facet.Start[c - 1]                  ? shape.Points[c - 1]
                                                                         : unknown--;
    }
    this->Received.push_back(shape);
    this->Boxes.push_back(BoundsOf(facet.X));
  }
}

} // namespace

std::vector<unsigned char> FindIntersections(const ActiveMesh& mesh, Runtime& runtime)
{
  FreeFacets facets(mesh, runtime.Group());
  std::vector<Bounds> bounds = facets.TakeBounds();
  std::vector<unsigned char> intersects(bounds.size(), 0);
  const BoxTree tree(std::move(bounds), runtime);
  tree.ForPairs(runtime,
    [&](Index f, Index g)
    {
      if (std::min(f, g) < facets.CountOwn() && DoIntersect(facets.At(f), facets.At(g)))
      {
        __atomic_store_n(&intersects[f], 1, __ATOMIC_RELAXED);
        __atomic_store_n(&intersects[g], 1, __ATOMIC_RELAXED);
      }
    });
  std::vector<unsigned char> points(mesh.X.size(), 0);
  for (Index f = 0; f < facets.CountOwn(); ++f)
  {
    if (intersects[f])
    {
      for (Index point : facets.At(f).Points)
      {
        points[point] = 1;
      }
    }
  }
  mesh.Exchange.ReturnAll([&](int mover) { return points[mover]; },
    [&](int mover, unsigned char flag) { points[mover] |= flag; });
  return points;
}

} // namespace vfm
