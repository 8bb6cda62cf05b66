#include "HexTopology.h"

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

std::vector<Index> FindOwnedHexes(const HexMesh& mesh, const CartesianGrid& grid)
{
  std::vector<Index> kept;
  for (std::size_t h = 0; h < mesh.HexIds.size(); ++h)
  {
    if (grid.Owned().Contains(CellOfHex(grid, mesh.HexIds[h])))
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

void KeepOwned(HexMesh& mesh, const CartesianGrid& grid)
{
  if (grid.HexBox() == grid.Owned())
  {
    return;
  }
  const std::vector<Index> hexes = FindOwnedHexes(mesh, grid);
  mesh.Hexes = Keep(mesh.Hexes, hexes, 8);
  mesh.HexIds = Keep(mesh.HexIds, hexes);
  mesh.Material = Keep(mesh.Material, hexes);
  mesh.Fragment = Keep(mesh.Fragment, hexes);

  std::vector<Index> numbers(mesh.PointIds.size(), -1), points;
  for (Index point : mesh.Hexes)
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
  Renumber(mesh.Hexes, numbers);
  mesh.Points = Keep(mesh.Points, points, 3);
  mesh.PointIds = Keep(mesh.PointIds, points);
  mesh.GeometryDimension = Keep(mesh.GeometryDimension, points);
  mesh.GeometryId = Keep(mesh.GeometryId, points);

  SurfaceQuads& surfaces = mesh.Surfaces;
  std::vector<Index> quads;
  for (std::size_t q = 0; q < surfaces.IsOwned.size(); ++q)
  {
    if (surfaces.IsOwned[q])
    {
      quads.push_back(static_cast<Index>(q));
    }
  }
  surfaces.Points = Keep(surfaces.Points, quads, 4);
  Renumber(surfaces.Points, numbers);
  surfaces.SurfaceId = Keep(surfaces.SurfaceId, quads);
  surfaces.MaterialPair = Keep(surfaces.MaterialPair, quads, 2);
  surfaces.DomainSide = Keep(surfaces.DomainSide, quads);
}

} // namespace vfm
