#include "Report/SeamFacets.h"

#include "Octree/LevelIds.h"
#include "Ranks/Agreement.h"
#include "Report/DomainSides.h"
#include "Report/ElementCorners.h"
#include "Report/MatchFaces.h"

namespace vfm
{
namespace
{

/// Returns the positions of the corners of a face.
std::vector<Vector3> CornersOf(const MeshData& mesh, const FaceIds& points)
{
  std::vector<Vector3> corners;
  for (Index point : points)
  {
    if (point >= 0)
    {
      corners.push_back(mesh.PointAt(point));
    }
  }
  return corners;
}

/// Returns whether the nodes of points may lie on a side of the domain.
std::vector<unsigned char> FindNodesOnSides(const Mesh& mesh)
{
  const CartesianGrid& domain = mesh.Levels->Finest();
  const Index end = EndOfPointIds(*mesh.Levels, mesh.Ids.PointSlots); // later ones are TetGen's
  std::vector<unsigned char> areOnSides(mesh.PointIds.size(), 0);
  for (std::size_t p = 0; p < areOnSides.size(); ++p)
  {
    const Index id = mesh.PointIds[p];
    areOnSides[p] = id < end && domain.DomainSides(NodeOfPoint(domain, mesh, id)) != 0;
  }
  return areOnSides;
}

/// Returns the facet of the same face, or null.
MeshFacet* FindFacet(std::vector<MeshFacet>& facets, const ElementSide& face)
{
  const auto found = std::lower_bound(facets.begin(), facets.end(), face);
  return found == facets.end() || face < *found ? nullptr : &*found;
}

/// Returns the faces of elements that have only nodes on sides of the domain, without those known
/// to be on the boundary.
std::vector<ElementSide> ListCandidates(Mesh& mesh)
{
  const std::vector<unsigned char> areOnSides = FindNodesOnSides(mesh);
  const ElementFaces faces(mesh.Corners);
  std::vector<ElementSide> found;
  for (Index element = 0; element < static_cast<Index>(mesh.ElementIds.size()); ++element)
  {
    for (int side = 0; side < faces.Count; ++side)
    {
      const FaceIds points = faces.PointsOf(mesh.Elements.data() + mesh.Corners * element, side);
      const bool isOnSide = std::all_of(points.begin(), points.end(),
        [&areOnSides](Index point) { return point < 0 || areOnSides[point] != 0; });
      const MeshFacet* listed = isOnSide ? FindFacet(mesh.Facets, { element, side }) : nullptr;
      if (isOnSide && (!listed || listed->Behind != NothingBehind))
      {
        found.push_back({ element, side });
      }
    }
  }
  return found;
}

} // namespace

std::vector<int> FindSeamSides(
  const MeshData& mesh, const std::vector<ElementSide>& faces, Ranks& ranks)
{
  const FacePlaces copies(mesh);
  std::vector<FaceIds> ids;
  std::vector<Index> places;
  for (const ElementSide& face : faces)
  {
    const FaceIds points = PointsOfSide(mesh, face);
    ids.push_back(SortedIds(points, mesh.PeriodicPartner));
    places.push_back(copies.Of(CornersOf(mesh, points)));
  }
  const std::vector<Index> others = MatchFaces(ids, places, ranks);
  std::vector<int> sides(faces.size(), NoSide);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const Index3 periods = others[f] == NothingBehind
      ? Index3{ { 0, 0, 0 } }
      : FacePlaces::PeriodsBetween(others[f], places[f]);
    for (int a = 2; a >= 0; --a)
    {
      sides[f] = periods[a] == 0 ? sides[f] : 2 * a + (periods[a] > 0 ? 1 : 0);
    }
  }
  return sides;
}

void AddSeamFacets(const std::vector<FieldArray>& fields, Ranks& ranks, Mesh& mesh)
{
  MeshData view = ViewMesh(mesh);
  view.Fields = fields;
  std::vector<ElementSide> faces;
  std::vector<FaceIds> ids;
  WorkTogether(ranks,
    [&]
    {
      faces = ListCandidates(mesh);
      for (const ElementSide& face : faces)
      {
        ids.push_back(SortedIds(PointsOfSide(view, face), mesh.PointIds.data()));
      }
    });
  const std::vector<Index> behind = MatchFaces(ids, std::vector<Index>(ids.size(), 0), ranks);
  std::vector<ElementSide> open;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (behind[f] == NothingBehind)
    {
      open.push_back(faces[f]);
    }
  }
  const std::vector<int> sides = FindSeamSides(view, open, ranks);
  std::vector<MeshFacet> added;
  for (std::size_t f = 0; f < open.size(); ++f)
  {
    const MeshFacet facet{ open[f].Element, open[f].Side, NothingBehind, 0, sides[f] };
    MeshFacet* listed = FindFacet(mesh.Facets, facet);
    if (facet.DomainSide != NoSide && listed)
    {
      *listed = facet;
    }
    else if (facet.DomainSide != NoSide)
    {
      added.push_back(facet);
    }
  }
  const auto before = static_cast<std::ptrdiff_t>(mesh.Facets.size());
  mesh.Facets.insert(mesh.Facets.end(), added.begin(), added.end());
  std::inplace_merge(mesh.Facets.begin(), mesh.Facets.begin() + before, mesh.Facets.end());
}

} // namespace vfm
