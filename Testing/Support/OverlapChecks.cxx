#include "OverlapChecks.h"

#include "Base/HexNumbering.h"
#include "Base/Vector3.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

constexpr double Touching = 1e-12; // overlap of projections that is rounding, in element widths
constexpr int MostHalvings = 5;    // of hexes whose tets overlap

using Tet = std::array<Vector3, 4>;

/// Edges of a tet.
constexpr int TetEdges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
/// Corners of the faces of a tet.
constexpr int TetFaces[4][3] = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, 3 } };

struct Bounds
{
  Vector3 Lower{ { 1e300, 1e300, 1e300 } }, Upper{ { -1e300, -1e300, -1e300 } };

  void Add(const Vector3& x)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Lower[a] = std::min(this->Lower[a], x[a]);
      this->Upper[a] = std::max(this->Upper[a], x[a]);
    }
  }
  bool Overlap(const Bounds& other) const
  {
    bool overlap = true;
    for (int a = 0; a < 3; ++a)
    {
      overlap = overlap && this->Lower[a] < other.Upper[a] && other.Lower[a] < this->Upper[a];
    }
    return overlap;
  }
};

template <class Points>
Bounds BoundsOf(const Points& points)
{
  Bounds bounds;
  for (const Vector3& x : points)
  {
    bounds.Add(x);
  }
  return bounds;
}

/// Part of an element that is convex.
struct Part
{
  Tet Corners;
  Bounds Box;
};

/// An element with its convex parts.
struct Solid
{
  Index Element = 0;
  Bounds Box;
  std::vector<Vector3> Corners;
  std::vector<Vector3> Normals; // of a hex's faces, of any length
  std::vector<Part> Parts;
  double Width = 0.0;
};

/// Returns the length of the common part of the projections of two sets of points on an axis, or
/// the largest number if the axis has no length.
template <class A, class B>
double ProjectedOverlap(const A& a, const B& b, const Vector3& axis)
{
  const double length = Norm(axis);
  if (!(length > 1e-200))
  {
    return 1e300;
  }
  const auto project = [&](const auto& points)
  {
    std::array<double, 2> range{ { 1e300, -1e300 } };
    for (const Vector3& x : points)
    {
      const double at = Dot(axis, x - a[0]);
      range = { { std::min(range[0], at), std::max(range[1], at) } };
    }
    return range;
  };
  const auto ofA = project(a), ofB = project(b);
  return std::min(ofA[1] - ofB[0], ofB[1] - ofA[0]) / length;
}

/// Returns the normal of a face of a tet, of any length.
Vector3 NormalOf(const Tet& tet, const int (&face)[3])
{
  return Cross(tet[face[1]] - tet[face[0]], tet[face[2]] - tet[face[0]]);
}

/// Returns the depth of the overlap of two tets; at most `touching` if they only touch. Convex
/// bodies are apart if and only if a plane parallel to a face of one, or to an edge of each,
/// separates them.
double DepthOf(const Tet& a, const Tet& b, double touching)
{
  double depth = 1e300;
  const auto isApart = [&](const Vector3& axis)
  {
    depth = std::min(depth, ProjectedOverlap(a, b, axis));
    return depth <= touching;
  };
  for (const auto& face : TetFaces)
  {
    if (isApart(NormalOf(a, face)) || isApart(NormalOf(b, face)))
    {
      return 0.0;
    }
  }
  for (const auto& e : TetEdges)
  {
    for (const auto& f : TetEdges)
    {
      if (isApart(Cross(a[e[1]] - a[e[0]], b[f[1]] - b[f[0]])))
      {
        return 0.0;
      }
    }
  }
  return depth;
}

double SixVolumes(const Tet& x)
{
  return Dot(x[1] - x[0], Cross(x[2] - x[0], x[3] - x[0]));
}

/// Returns the mean of some corners of a hex.
template <class Numbers>
Vector3 MeanOf(const std::vector<Vector3>& corners, const Numbers& numbers)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int c : numbers)
  {
    sum = sum + corners[c];
  }
  return 1.0 / static_cast<double>(numbers.size()) * sum;
}

void AddPart(const Tet& corners, Solid& solid)
{
  solid.Parts.push_back({ corners, BoundsOf(corners) });
}

void FindParts(Solid& solid)
{
  const std::vector<Vector3>& x = solid.Corners;
  if (x.size() == 4)
  {
    AddPart({ { x[0], x[1], x[2], x[3] } }, solid);
    return;
  }
  const Vector3 centre = MeanOf(x, std::array<int, 8>{ { 0, 1, 2, 3, 4, 5, 6, 7 } });
  for (const auto& face : FaceCorners)
  {
    const Vector3 middle = MeanOf(x, face);
    for (int c = 0; c < 4; ++c)
    {
      AddPart({ { centre, middle, x[face[c]], x[face[(c + 1) % 4]] } }, solid);
    }
  }
}

void FindNormals(Solid& solid)
{
  const std::vector<Vector3>& x = solid.Corners;
  if (x.size() == 4)
  {
    return; // DepthOf has them
  }
  for (const auto& face : FaceCorners)
  {
    solid.Normals.push_back(Cross(x[face[2]] - x[face[0]], x[face[3]] - x[face[1]]));
  }
}

/// corners: of a hex by bits, or of a tet.
Solid MakeSolid(std::vector<Vector3> corners)
{
  Solid solid;
  solid.Corners = std::move(corners);
  solid.Box = BoundsOf(solid.Corners);
  FindNormals(solid);
  FindParts(solid);
  double volume = 0.0;
  for (const Part& part : solid.Parts)
  {
    volume += std::abs(SixVolumes(part.Corners)) / 6.0;
  }
  solid.Width = std::cbrt(volume);
  return solid;
}

Solid MakeSolid(const Mesh& mesh, Index element)
{
  std::vector<Vector3> corners;
  for (int c = 0; c < mesh.Corners; ++c)
  {
    const int at = mesh.HasHexes() ? VtkCorner[c] : c;
    const double* x = mesh.Points.data() + 3 * mesh.Elements[mesh.Corners * element + at];
    corners.push_back({ { x[0], x[1], x[2] } });
  }
  Solid solid = MakeSolid(std::move(corners));
  solid.Element = element;
  return solid;
}

/// Returns whether a plane parallel to a face separates two hexes.
bool AreApart(const Solid& a, const Solid& b, double touching)
{
  const auto separates = [&](const Vector3& axis)
  { return ProjectedOverlap(a.Corners, b.Corners, axis) <= touching; };
  return std::any_of(a.Normals.begin(), a.Normals.end(), separates) ||
    std::any_of(b.Normals.begin(), b.Normals.end(), separates);
}

/// Returns the depth of the overlap of the tets of two elements.
double DepthOfParts(const Solid& a, const Solid& b, double touching)
{
  double depth = 0.0;
  for (const Part& p : a.Parts)
  {
    for (const Part& q : b.Parts)
    {
      if (p.Box.Overlap(b.Box) && p.Box.Overlap(q.Box))
      {
        depth = std::max(depth, DepthOf(p.Corners, q.Corners, touching));
      }
    }
  }
  return depth;
}

/// Returns the eight parts of a halved hex.
std::vector<Solid> Halve(const Solid& hex)
{
  std::vector<Vector3> nodes; // of the hex's 2 x 2 x 2 parts
  for (int n = 0; n < 27; ++n)
  {
    const int at[3] = { n % 3, n / 3 % 3, n / 9 };
    std::array<int, 8> corners;
    for (int c = 0; c < 8; ++c)
    {
      corners[c] = 0;
      for (int a = 0; a < 3; ++a)
      {
        corners[c] |= (at[a] == 1 ? c >> a & 1 : at[a] / 2) << a;
      }
    }
    nodes.push_back(MeanOf(hex.Corners, corners));
  }
  std::vector<Solid> parts;
  for (int p = 0; p < 8; ++p)
  {
    std::vector<Vector3> corners;
    for (int c = 0; c < 8; ++c)
    {
      const int x = (p & 1) + (c & 1), y = (p >> 1 & 1) + (c >> 1 & 1), z = (p >> 2) + (c >> 2);
      corners.push_back(nodes[x + 3 * y + 9 * z]);
    }
    parts.push_back(MakeSolid(std::move(corners)));
  }
  return parts;
}

/// Returns whether two hexes overlap, told by the tets of their parts after some halvings.
bool DoOverlap(const Solid& a, const Solid& b, int halvings, double touching)
{
  if (!a.Box.Overlap(b.Box) || AreApart(a, b, touching))
  {
    return false;
  }
  if (halvings == 0)
  {
    return DepthOfParts(a, b, touching) > 0.0;
  }
  const std::vector<Solid> ofA = Halve(a), ofB = Halve(b);
  return std::any_of(ofA.begin(), ofA.end(),
    [&](const Solid& p)
    {
      return p.Box.Overlap(b.Box) &&
        std::any_of(ofB.begin(), ofB.end(),
          [&](const Solid& q) { return DoOverlap(p, q, halvings - 1, touching); });
    });
}

/// Returns an element relative to a place. Near it the differences are exact, so that the rounding
/// of halved edges does not count as an overlap far from the origin.
Solid Relative(const Solid& solid, const Vector3& place)
{
  std::vector<Vector3> corners = solid.Corners;
  for (Vector3& x : corners)
  {
    x = x - place;
  }
  return MakeSolid(std::move(corners));
}

/// Returns the depth of the overlap of two elements in the width of the smaller.
double DepthOf(const Solid& one, const Solid& other)
{
  const double width = std::min(one.Width, other.Width), touching = Touching * width;
  if (AreApart(one, other, touching))
  {
    return 0.0;
  }
  const Solid a = Relative(one, one.Corners[0]), b = Relative(other, one.Corners[0]);
  const double depth = DepthOfParts(a, b, touching);
  const bool areHexes = a.Corners.size() == 8;
  return depth > 0.0 && (!areHexes || DoOverlap(a, b, MostHalvings, touching)) ? depth / width
                                                                               : 0.0;
}

bool ShareFace(const Mesh& mesh, Index a, Index b)
{
  const Index *ofA = mesh.Elements.data() + mesh.Corners * a,
              *ofB = mesh.Elements.data() + mesh.Corners * b;
  const auto common = std::count_if(ofA, ofA + mesh.Corners,
    [&](Index p) { return std::find(ofB, ofB + mesh.Corners, p) != ofB + mesh.Corners; });
  return common >= mesh.CornersOfFacet();
}

/// Returns the points of facets between meshed and unmeshed cells, without sides of the domain.
std::set<Index> ListFreePoints(const Mesh& mesh)
{
  std::set<Index> points;
  const int corners = mesh.CornersOfFacet();
  const bool hasVoid =
    std::find(mesh.Material.begin(), mesh.Material.end(), 0) != mesh.Material.end();
  for (std::size_t f = 0; !hasVoid && f < mesh.Surfaces.SurfaceId.size(); ++f)
  {
    if (mesh.Surfaces.DomainSide[f] < 0 && mesh.Surfaces.MaterialPair[2 * f] == 0)
    {
      const Index* facet = mesh.Surfaces.Points.data() + corners * f;
      points.insert(facet, facet + corners);
    }
  }
  return points;
}

/// Returns the elements with a point next to unmeshed void, ascending by their lowest x.
std::vector<Solid> ListFreeSolids(const Mesh& mesh)
{
  const std::set<Index> points = ListFreePoints(mesh);
  std::vector<Solid> solids;
  for (Index e = 0; e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    const Index* own = mesh.Elements.data() + mesh.Corners * e;
    if (std::any_of(own, own + mesh.Corners, [&](Index p) { return points.count(p) > 0; }))
    {
      solids.push_back(MakeSolid(mesh, e));
    }
  }
  std::sort(solids.begin(), solids.end(),
    [](const Solid& a, const Solid& b) { return a.Box.Lower[0] < b.Box.Lower[0]; });
  return solids;
}

} // namespace

ElementOverlaps FindElementOverlaps(const Mesh& mesh)
{
  const std::vector<Solid> solids = ListFreeSolids(mesh);
  ElementOverlaps found;
  for (std::size_t a = 0; a < solids.size(); ++a)
  {
    for (std::size_t b = a + 1;
         b < solids.size() && solids[b].Box.Lower[0] < solids[a].Box.Upper[0]; ++b)
    {
      const Solid &first = solids[a], &second = solids[b];
      if (!first.Box.Overlap(second.Box) || ShareFace(mesh, first.Element, second.Element))
      {
        continue;
      }
      const double depth = DepthOf(first, second);
      found.Pairs += depth > 0.0;
      if (depth > found.Depth)
      {
        found.Depth = depth;
        found.Deepest = { { mesh.ElementIds[first.Element], mesh.ElementIds[second.Element] } };
      }
    }
  }
  return found;
}

Index CountCoincidentPoints(const Mesh& mesh)
{
  std::set<Vector3> places;
  const Index points = static_cast<Index>(mesh.PointIds.size());
  for (Index p = 0; p < points; ++p)
  {
    const double* x = mesh.Points.data() + 3 * p;
    places.insert({ { x[0], x[1], x[2] } });
  }
  return points - static_cast<Index>(places.size());
}

} // namespace testing
} // namespace vfm
