#include "Mesh/FacetSides.h"

namespace vfm
{
namespace
{

bool IsBefore(const FacetSide& side, const FacetSide& other)
{
  return side.Points < other.Points;
}

/// Adds the side of a facet on which the material with position `own` in the pair is.
void AddSide(const Mesh& mesh, std::size_t facet, int own, const FaceIds& points,
  std::vector<FacetSide>& sides)
{
  const SurfaceFacets& surfaces = mesh.Surfaces;
  const int id = surfaces.SurfaceId[facet], domainSide = surfaces.DomainSide[facet];
  const GeometryTables::Pair& volumes = mesh.Tables.SurfaceVolumes[id - 1];
  if (volumes[own] == 0)
  {
    return;
  }
  const int behind = 1 - own;
  const bool isSmoothSide = domainSide < 0 && mesh.Tables.SurfaceParts[id - 1] > 0;
  sides.push_back({ points,
    { 0, 0, volumes[behind] > 0 ? surfaces.MaterialPair[2 * facet + behind] : NothingBehind,
      isSmoothSide ? id : 0, domainSide } });
}

} // namespace

std::vector<FacetSide> ListFacetSides(const Mesh& mesh)
{
  const int corners = mesh.CornersOfFacet();
  const auto surfaces = static_cast<int>(mesh.Tables.SurfaceVolumes.size());
  std::vector<FacetSide> sides;
  for (std::size_t facet = 0; facet < mesh.Surfaces.SurfaceId.size(); ++facet)
  {
    FaceIds points{ { -1, -1, -1, -1 } };
    std::copy_n(mesh.Surfaces.Points.data() + corners * facet, corners, points.end() - corners);
    std::sort(points.begin(), points.end());
    // Facets outside the elements of this rank may be on surfaces without a number.
    if (points[4 - corners] >= 0 && mesh.Surfaces.SurfaceId[facet] <= surfaces)
    {
      AddSide(mesh, facet, 0, points, sides);
      AddSide(mesh, facet, 1, points, sides);
    }
  }
  return sides;
}

std::vector<FacetSide> ListPointsOfFacets(const Mesh& mesh)
{
  const ElementFaces faces(mesh.Corners);
  std::vector<FacetSide> sides;
  for (const MeshFacet& facet : mesh.Facets)
  {
    const Index* element = mesh.Elements.data() + mesh.Corners * facet.Element;
    sides.push_back({ faces.PointsOf(element, facet.Side), facet });
  }
  return sides;
}

std::vector<MeshFacet> FindElements(std::vector<FacetSide> sides, const Mesh& mesh)
{
  for (FacetSide& side : sides)
  {
    std::sort(side.Points.begin(), side.Points.end());
  }
  std::sort(sides.begin(), sides.end(), IsBefore);
  const ElementFaces faces(mesh.Corners);
  const auto isInside = [&mesh](Index point)
  { return point >= 0 && mesh.GeometryDimension[point] >= DimensionOfVolumes; };
  std::vector<MeshFacet> facets;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    for (int face = 0; face < faces.Count; ++face)
    {
      FacetSide side{ faces.PointsOf(mesh.Elements.data() + mesh.Corners * e, face), {} };
      if (std::any_of(side.Points.begin(), side.Points.end(), isInside))
      {
        continue;
      }
      std::sort(side.Points.begin(), side.Points.end());
      const auto [begin, end] = std::equal_range(sides.begin(), sides.end(), side, IsBefore);
      const auto found = std::find_if(
        begin, end, [&](const FacetSide& other) { return other.Facet.Behind != mesh.Material[e]; });
      if (found != end)
      {
        facets.push_back(found->Facet);
        facets.back().Element = static_cast<Index>(e);
        facets.back().Side = face;
      }
    }
  }
  return facets;
}

} // namespace vfm
