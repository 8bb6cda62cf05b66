#include "Mesh/KeepOwned.h"

#include "Mesh/FacetSides.h"

namespace vfm
{
namespace
{

/// Returns the items with the given indices.
/// @param width  values per item
template <class T>
Buffer<T> Select(const Buffer<T>& items, const std::vector<Index>& kept, Index width = 1)
{
  Buffer<T> result(kept.size() * width);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    std::copy_n(items.data() + width * kept[i], width, result.data() + width * i);
  }
  return result;
}

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

void Renumber(Buffer<Index>& points, const std::vector<Index>& numbers)
{
  for (Index& point : points)
  {
    point = numbers[point];
  }
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
  Renumber(mesh.Elements, numbers);
  mesh.Points = Select(mesh.Points, points, 3);
  mesh.PointIds = Select(mesh.PointIds, points);
  mesh.GeometryDimension = Select(mesh.GeometryDimension, points);
  mesh.GeometryId = Select(mesh.GeometryId, points);

  SurfaceFacets& surfaces = mesh.Surfaces;
  Renumber(surfaces.Points, numbers);
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
  Renumber(mesh.Curves.Points, numbers);
  Renumber(mesh.Vertices.Points, numbers);
}

} // namespace vfm
