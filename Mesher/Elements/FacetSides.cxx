#include "Elements/FacetSides.h"

#include "Base/Groups.h"

namespace vfm
{
namespace
{

constexpr Index FacetsOfBlock = 4096, ElementsOfBlock = 4096; // per task

/// Adds the side of a facet on which the material with position `own` in the pair is.
/// @param row  of the surface in the tables
void AddSide(const Mesh& mesh, std::size_t facet, std::ptrdiff_t row, int own,
  const FaceIds& points, std::vector<FacetSide>& sides)
{
  const SurfaceFacets& surfaces = mesh.Surfaces;
  const int id = surfaces.SurfaceId[facet], domainSide = surfaces.DomainSide[facet];
  const GeometryTables::Pair& volumes = mesh.Tables.SurfaceVolumes[row];
  if (volumes[own] == 0)
  {
    return;
  }
  const int behind = 1 - own;
  const bool isSmoothSide = domainSide < 0 && mesh.Tables.SurfaceParts[row] > 0;
  sides.push_back({ points,
    { 0, 0, volumes[behind] > 0 ? surfaces.MaterialPair[2 * facet + behind] : NothingBehind,
      isSmoothSide ? id : 0, domainSide } });
}

} // namespace

std::vector<FacetSide> ListFacetSides(const Mesh& mesh, Runtime& runtime)
{
  const int corners = mesh.CornersOfFacet();
  return CollectItems<FacetSide>(runtime, mesh.Surfaces.SurfaceId.size(), FacetsOfBlock,
    [&](Index facet, std::vector<FacetSide>& sides)
    {
      FaceIds points{ { -1, -1, -1, -1 } };
      std::copy_n(mesh.Surfaces.Points.data() + corners * facet, corners, points.end() - corners);
      std::sort(points.begin(), points.end());
      // Facets outside the elements of this rank may be on surfaces without a number.
      const std::ptrdiff_t row =
        points[4 - corners] >= 0 ? mesh.Tables.RowOfSurface(mesh.Surfaces.SurfaceId[facet]) : -1;
      if (row >= 0)
      {
        AddSide(mesh, facet, row, 0, points, sides);
        AddSide(mesh, facet, row, 1, points, sides);
      }
    });
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

namespace
{

/// Facets by their last point.
class SidesAtPoints
{
public:
  SidesAtPoints(std::vector<FacetSide> sides, std::size_t points, Runtime& runtime) :
    Sides(std::move(sides))
  {
    ForEach(runtime, this->Sides.size(),
      [this](Index s) { std::sort(this->Sides[s].Points.begin(), this->Sides[s].Points.end()); });
    this->At = MakeGroups<int>(points,
      [this](const auto& visit)
      {
        for (std::size_t s = 0; s < this->Sides.size(); ++s)
        {
          visit(this->Sides[s].Points.back(), static_cast<int>(s));
        }
      });
  }

  /// Returns the facet with these points that is not in front of a material, or nullptr.
  /// @param points  ascending
  const MeshFacet* Find(const FaceIds& points, int material) const
  {
    for (Index at = this->At.Begin[points.back()]; at < this->At.Begin[points.back() + 1]; ++at)
    {
      const FacetSide& side = this->Sides[this->At.Items[at]];
      if (side.Points == points && side.Facet.Behind != material)
      {
        return &side.Facet;
      }
    }
    return nullptr;
  }

private:
  std::vector<FacetSide> Sides;
  Groups<int> At;
};

} // namespace

std::vector<MeshFacet> FindElements(
  std::vector<FacetSide> sides, const Mesh& mesh, Runtime& runtime)
{
  const SidesAtPoints known(std::move(sides), mesh.PointIds.size(), runtime);
  const ElementFaces faces(mesh.Corners);
  const auto isInside = [&mesh](Index point)
  { return point >= 0 && mesh.GeometryDimension[point] >= DimensionOfVolumes; };
  return CollectItems<MeshFacet>(runtime, mesh.ElementIds.size(), ElementsOfBlock,
    [&](Index e, std::vector<MeshFacet>& facets)
    {
      for (int face = 0; face < faces.Count; ++face)
      {
        FaceIds points = faces.PointsOf(mesh.Elements.data() + mesh.Corners * e, face);
        if (std::any_of(points.begin(), points.end(), isInside))
        {
          continue;
        }
        std::sort(points.begin(), points.end());
        if (const MeshFacet* found = known.Find(points, mesh.Material[e]))
        {
          facets.push_back(*found);
          facets.back().Element = e;
          facets.back().Side = face;
        }
      }
    });
}

} // namespace vfm
