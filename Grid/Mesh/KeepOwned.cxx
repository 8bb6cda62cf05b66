#include "Mesh/KeepOwned.h"

#include "Mesh/FacetSides.h"

namespace vfm
{
namespace
{

/// The items whose index is kept, in order; several values an item.
template <class T>
Buffer<T> Keep(const Buffer<T>& items, const std::vector<Index>& kept, Index width = 1)
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
    if (grid.Owned().Contains(CellOfElement(grid, mesh, mesh.ElementIds[h])))
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
  if (grid.HexBox() == grid.Owned())
  {
    mesh.Facets = FindElements(ListFacetSides(mesh), mesh);
    return;
  }
  const std::vector<Index> elements = FindOwnedElements(mesh, grid);
  mesh.WholeCells =
    std::lower_bound(elements.begin(), elements.end(), mesh.WholeCells) - elements.begin();
  mesh.Elements = Keep(mesh.Elements, elements, mesh.Corners);
  mesh.ElementIds = Keep(mesh.ElementIds, elements);
  mesh.Material = Keep(mesh.Material, elements);
  mesh.Fragment = Keep(mesh.Fragment, elements);

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
  mesh.Points = Keep(mesh.Points, points, 3);
  mesh.PointIds = Keep(mesh.PointIds, points);
  mesh.GeometryDimension = Keep(mesh.GeometryDimension, points);
  mesh.GeometryId = Keep(mesh.GeometryId, points);

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
  surfaces.Points = Keep(surfaces.Points, facets, mesh.CornersOfFacet());
  surfaces.SurfaceId = Keep(surfaces.SurfaceId, facets);
  surfaces.MaterialPair = Keep(surfaces.MaterialPair, facets, 2);
  surfaces.DomainSide = Keep(surfaces.DomainSide, facets);
  Renumber(mesh.Curves.Points, numbers);
  Renumber(mesh.Vertices.Points, numbers);
}

} // namespace vfm
