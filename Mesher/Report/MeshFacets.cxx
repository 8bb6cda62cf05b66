#include "Report/MeshFacets.h"

#include "Ranks/Agreement.h"
#include "Report/DomainSides.h"
#include "Report/FlatData.h"
#include "Report/MatchFaces.h"
#include "Report/MeshFields.h"
#include "Report/SeamFacets.h"

#include <map>

namespace vfm
{
namespace
{

/// Returns the faces that can be on a surface. Points on periodic sides count as inside a volume.
std::vector<MeshFacet> CollectFaces(const MeshData& mesh)
{
  const int sides = SidesOf(mesh), inside = DimensionInside(mesh);
  const int* dimensions = mesh.PeriodicPartner ? nullptr : mesh.GeometryDimension;
  const auto isInside = [dimensions, inside](Index point)
  { return point >= 0 && dimensions && dimensions[point] >= inside; };
  std::vector<MeshFacet> faces;
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    for (int side = 0; side < sides; ++side)
    {
      const FaceIds points = PointsOfSide(mesh, { element, side });
      if (std::none_of(points.begin(), points.end(), isInside))
      {
        faces.push_back({ element, side, NothingBehind, 0, NoSide });
      }
    }
  }
  return faces;
}

/// Finds the smooth side of an interface that contains a face: the surface of its points inside a
/// surface, or the entry of the face in EdgeFacets.
class FaceSurfaces
{
public:
  explicit FaceSurfaces(const MeshData& mesh) : TheMesh(mesh)
  {
    const std::vector<double> parts = NumbersOfField(mesh.Fields, "SurfaceParts");
    const std::vector<double> ids = NumbersOfField(mesh.Fields, "SurfaceIds");
    for (std::size_t row = 0; row < parts.size(); ++row)
    {
      if (parts[row] >= 1.0)
      {
        this->Sides.push_back(
          row < ids.size() ? static_cast<int>(ids[row]) : static_cast<int>(row) + 1);
      }
    }
    for (const auto& row : ReadEdgeFacets(mesh.Fields))
    {
      this->EdgeFacets[{ { row[0], row[1], row[2], row[3] } }] = static_cast<int>(row[4]);
    }
  }

  int Find(const MeshFacet& facet) const
  {
    const MeshData& mesh = this->TheMesh;
    if (this->Sides.empty() || !mesh.GeometryDimension || !mesh.GeometryId)
    {
      return 0;
    }
    const FaceIds points = PointsOfSide(mesh, facet);
    int surface = 0;
    for (Index point : points)
    {
      if (point >= 0 && mesh.GeometryDimension[point] == DimensionOfSurfaces)
      {
        surface = std::max(surface, mesh.GeometryId[point]);
      }
    }
    const auto listed = this->EdgeFacets.find(SortedIds(points, mesh.UnsplitPointIds()));
    surface = listed == this->EdgeFacets.end() ? surface : listed->second;
    return std::binary_search(this->Sides.begin(), this->Sides.end(), surface) ? surface : 0;
  }

private:
  const MeshData& TheMesh;
  std::vector<int> Sides; // surfaces that are smooth sides, ascending
  std::map<FaceIds, int> EdgeFacets;
};

/// Collective. Sets the sides of the domain on which faces lie.
void FindSides(const MeshData& mesh, Ranks& ranks, std::vector<MeshFacet>& facets)
{
  const DomainSides domain(mesh);
  std::vector<ElementSide> open;
  std::vector<int*> sides;
  for (MeshFacet& facet : facets)
  {
    if (facet.Behind == NothingBehind)
    {
      facet.DomainSide = domain.SideOfFace(PointsOfSide(mesh, facet));
      open.push_back(facet);
      sides.push_back(&facet.DomainSide);
    }
  }
  if (!ranks.Any(mesh.PeriodicPartner != nullptr))
  {
    return;
  }
  const std::vector<int> seams = FindSeamSides(mesh, open, ranks);
  for (std::size_t f = 0; f < open.size(); ++f)
  {
    int& side = *sides[f];
    side = seams[f] != NoSide || domain.IsPeriodic(side) ? seams[f] : side;
  }
}

} // namespace

std::vector<MeshFacet> FindMeshFaces(const MeshData& mesh, const int* values, Ranks& ranks)
{
  std::vector<MeshFacet> faces;
  std::vector<Index> valuesOfFaces;
  std::vector<FaceIds> ids;
  WorkTogether(ranks,
    [&]
    {
      Require(mesh.PointIds, "GlobalPointIds", mesh);
      faces = CollectFaces(mesh);
      for (const MeshFacet& face : faces)
      {
        valuesOfFaces.push_back(values[face.Element]);
        ids.push_back(SortedIds(PointsOfSide(mesh, face), mesh.UnsplitPointIds()));
      }
    });
  const std::vector<Index> behind = MatchFaces(ids, valuesOfFaces, ranks);
  std::vector<MeshFacet> found;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (behind[f] != valuesOfFaces[f])
    {
      found.push_back(faces[f]);
      found.back().Behind = static_cast<int>(behind[f]);
    }
  }
  return found;
}

std::vector<MeshFacet> FindMeshFacets(const MeshData& mesh, Ranks& ranks)
{
  if (!ranks.Any(mesh.NumberOfElements > 0 && !mesh.Facets))
  {
    return mesh.Facets ? *mesh.Facets : std::vector<MeshFacet>();
  }
  WorkTogether(ranks, [&mesh] { Require(mesh.Material, "MaterialId", mesh); });
  std::vector<MeshFacet> facets = FindMeshFaces(mesh, mesh.Material, ranks);
  FindSides(mesh, ranks, facets);
  const FaceSurfaces surfaces(mesh);
  for (MeshFacet& facet : facets)
  {
    facet.Surface = facet.DomainSide == NoSide ? surfaces.Find(facet) : 0;
  }
  return facets;
}

} // namespace vfm
