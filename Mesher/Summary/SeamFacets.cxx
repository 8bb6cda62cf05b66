#include "Summary/SeamFacets.h"

#include "Mesh/ElementFaces.h"
#include "Octree/LevelIds.h"
#include "Ranks/Agreement.h"
#include "Summary/MatchFaces.h"

#include <cmath>
#include <tuple>

namespace vfm
{
namespace
{

/// Faces of elements, and the sides of the domain (bits) on which all their nodes lie.
struct Candidates
{
  std::vector<MeshFacet> Faces;
  std::vector<int> Sides;
  std::vector<FaceIds> Ids; // global ids of the points, sorted
};

/// Returns the sides across periodic axes on which the node of each point lies.
std::vector<unsigned char> FindSides(
  const CartesianGrid& domain, const std::array<bool, 3>& isPeriodic, const Mesh& mesh)
{
  int periodic = 0;
  for (int a = 0; a < 3; ++a)
  {
    periodic |= isPeriodic[a] ? 3 << (2 * a) : 0;
  }
  const Index end = EndOfPointIds(*mesh.Levels, mesh.Ids.PointSlots); // later ones are TetGen's
  std::vector<unsigned char> sides(mesh.PointIds.size(), 0);
  for (std::size_t p = 0; p < sides.size(); ++p)
  {
    const Index id = mesh.PointIds[p];
    const int own = id < end ? domain.DomainSides(NodeOfPoint(domain, mesh, id)) : 0;
    sides[p] = static_cast<unsigned char>(own & periodic);
  }
  return sides;
}

bool IsBefore(const MeshFacet& a, const MeshFacet& b)
{
  return std::tie(a.Element, a.Side) < std::tie(b.Element, b.Side);
}

Candidates ListCandidates(const std::vector<unsigned char>& sides, const Mesh& mesh)
{
  Candidates found;
  const ElementFaces faces(mesh.Corners);
  for (Index element = 0; element < static_cast<Index>(mesh.ElementIds.size()); ++element)
  {
    for (int side = 0; side < faces.Count; ++side)
    {
      FaceIds points = faces.PointsOf(mesh.Elements.data() + mesh.Corners * element, side);
      int common = 63;
      for (Index& point : points)
      {
        common &= point < 0 ? 63 : sides[point];
        point = point < 0 ? -1 : mesh.PointIds[point];
      }
      const MeshFacet facet{ element, side, NothingBehind, 0, -1 };
      if (common != 0 &&
        !std::binary_search(mesh.Facets.begin(), mesh.Facets.end(), facet, IsBefore))
      {
        std::sort(points.begin(), points.end());
        found.Faces.push_back(facet);
        found.Sides.push_back(common);
        found.Ids.push_back(points);
      }
    }
  }
  return found;
}

/// Returns the side among several whose axis is nearest to the normal of a face.
int NearestSide(const Mesh& mesh, const MeshFacet& face, int sides)
{
  const std::array<Index, 4> points = ElementFaces(mesh.Corners)
    .PointsOf(mesh.Elements.data() + mesh.Corners * face.Element, face.Side);
  const Vector3 a = mesh.PointAt(points[0]), b = mesh.PointAt(points[1]),
                c = mesh.PointAt(points[2]), d = points[3] < 0 ? a : mesh.PointAt(points[3]);
  int nearest = -1;
  double greatest = -1.0;
  for (int side = 0; side < 6; ++side)
  {
    const int u = (side / 2 + 1) % 3, v = (side / 2 + 2) % 3;
    const double area =
      std::abs((c[u] - a[u]) * (d[v] - b[v]) - (c[v] - a[v]) * (d[u] - b[u])); // twice the area
    if ((sides >> side & 1) != 0 && area > greatest)
    {
      nearest = side;
      greatest = area;
    }
  }
  return nearest;
}

} // namespace

void AddSeamFacets(
  const CartesianGrid& domain, const std::array<bool, 3>& isPeriodic, Ranks& ranks, Mesh& mesh)
{
  Candidates found;
  WorkTogether(ranks,
    [&] { found = ListCandidates(FindSides(domain, isPeriodic, mesh), mesh); });
  const std::vector<Index> behind =
    MatchFaces(found.Ids, std::vector<Index>(found.Ids.size(), 0), ranks);
  const std::size_t before = mesh.Facets.size();
  for (std::size_t f = 0; f < behind.size(); ++f)
  {
    if (behind[f] == NothingBehind)
    {
      mesh.Facets.push_back(found.Faces[f]);
      mesh.Facets.back().DomainSide = NearestSide(mesh, found.Faces[f], found.Sides[f]);
    }
  }
  std::inplace_merge(
    mesh.Facets.begin(), mesh.Facets.begin() + before, mesh.Facets.end(), IsBefore);
}

} // namespace vfm
