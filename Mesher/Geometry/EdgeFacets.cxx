#include "Geometry/EdgeFacets.h"

#include "Base/Sorted.h"
#include "Elements/FacetSides.h"
#include "Elements/PeriodicIds.h"

namespace vfm
{
namespace
{

/// Returns whether a surface is that of the points of a facet inside surfaces.
/// @param points  triangles may have a negative one first
bool IsKnownFromPoints(const Mesh& mesh, const FaceIds& points, int surface)
{
  int inside = 0, others = 0;
  for (Index point : points)
  {
    if (point >= 0 && mesh.GeometryDimension[point] == DimensionOfSurfaces)
    {
      ++inside;
      others += mesh.GeometryId[point] != surface;
    }
  }
  return inside > 0 && others == 0;
}

/// Adds the row of a facet if its points do not tell its surface.
/// @param idOf  idOf(point)
template <class IdOf>
void AddRow(
  const Mesh& mesh, const FaceIds& points, int surface, const IdOf& idOf, EdgeFacetRows& rows)
{
  if (IsKnownFromPoints(mesh, points, surface))
  {
    return;
  }
  std::array<std::int64_t, 5> row;
  std::transform(points.begin(), points.end(), row.begin(),
    [&idOf](Index point) { return point < 0 ? -1 : idOf(point); });
  std::sort(row.begin(), row.begin() + 4);
  row[4] = surface;
  rows.push_back(row);
}

} // namespace

EdgeFacetRows ListEdgeFacets(
  const std::vector<Facet>& facets, const std::vector<int>& sides, const Mesh& mesh)
{
  const int corners = mesh.CornersOfFacet();
  EdgeFacetRows rows;
  for (std::size_t q = 0; q < facets.size(); ++q)
  {
    if (sides[q] > 0 && facets[q].IsOwned)
    {
      FaceIds points{ { -1, -1, -1, -1 } };
      std::copy_n(mesh.Surfaces.Points.data() + corners * q, corners, points.end() - corners);
      AddRow(
        mesh, points, mesh.Surfaces.SurfaceId[q],
        [&mesh](Index point) { return IdOfOwner(mesh, mesh.PointIds[point]); }, rows);
    }
  }
  SortUnique(rows);
  return rows;
}

EdgeFacetRows ListEdgeFacetsOfElements(const Mesh& mesh)
{
  EdgeFacetRows rows;
  for (const FacetSide& side : ListPointsOfFacets(mesh))
  {
    if (side.Facet.Surface > 0)
    {
      AddRow(
        mesh, side.Points, side.Facet.Surface,
        [&mesh](Index point) { return mesh.UnsplitPointIds()[point]; }, rows);
    }
  }
  SortUnique(rows);
  return rows;
}

} // namespace vfm
