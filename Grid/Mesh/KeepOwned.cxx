#include "Mesh/KeepOwned.h"

#include "Mesh/FacetSides.h"
#include "Mesh/SelectPoints.h"

namespace vfm
{
namespace
{

std::vector<Index> FindOwnedElements(const Mesh& mesh, const CartesianGrid& grid)
{
  std::vector<Index> kept;
  for (std::size_t h = 0; h < mesh.ElementIds.size(); ++h)
  {
    if (!mesh.IsBarrier(static_cast<Index>(h)) &&
      grid.Owned().Contains(CellOfElement(grid, mesh, mesh.ElementIds[h])))
    {
      kept.push_back(static_cast<Index>(h));
    }
  }
  return kept;
}

} // namespace

void KeepOwned(Mesh& mesh, const CartesianGrid& grid)
{
  if (grid.HexBox() == grid.Owned() && !mesh.HasBarrier)
  {
    mesh.Facets = FindElements(ListFacetSides(mesh), mesh);
    return;
  }
  const std::vector<Index> elements = FindOwnedElements(mesh, grid);
  mesh.WholeCells =
    std::lower_bound(elements.begin(), elements.end(), mesh.WholeCells) - elements.begin();
  mesh.Elements = Select(mesh.Elements, elements, mesh.Corners);
  mesh.ElementIds = Select(mesh.ElementIds, elements);
  mesh.Material = Select(mesh.Material, elements);
  mesh.Fragment = Select(mesh.Fragment, elements);
  mesh.HasBarrier = false;

  std::vector<Index> numbers(mesh.PointIds.size(), -1), points;
  for (Index point : mesh.Elements)
  {
    numbers[point] = 0;
  }
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    if (numbers[p] == 0)
    {
      numbers[p] = static_cast<Index>(points.size());
      points.push_back(static_cast<Index>(p));
    }
  }
  SelectPoints(points, numbers, mesh);

  SurfaceFacets& surfaces = mesh.Surfaces;
  mesh.Facets = FindElements(ListFacetSides(mesh), mesh);
  std::vector<Index> facets;
  for (std::size_t q = 0; q < surfaces.IsOwned.size(); ++q)
  {
    if (surfaces.IsOwned[q])
    {
      facets.push_back(static_cast<Index>(q));
    }
  }
  surfaces.Points = Select(surfaces.Points, facets, mesh.CornersOfFacet());
  surfaces.SurfaceId = Select(surfaces.SurfaceId, facets);
  surfaces.MaterialPair = Select(surfaces.MaterialPair, facets, 2);
  surfaces.DomainSide = Select(surfaces.DomainSide, facets);
}

} // namespace vfm
