/**
 * A mesh whose hexes are the cells of a grid, for tests of single sources.
 */
#pragma once

#include "Base/HexNumbering.h"
#include "Elements/Mesh.h"
#include "Octree/RefinedGrid.h"

#include <functional>
#include <map>

namespace vfm
{
namespace testing
{

/// Adds the sides of the domain and the faces between materials to a mesh of the cells of a box.
/// Surfaces have numbers in the order of materials behind, before and side of the domain. The point
/// of one surface has dimension 2 and its number, a point of several has dimension 1.
inline void AddCellFacets(const CartesianGrid& grid, const IndexBox& cells,
  const std::function<int(const Index3&)>& materialOf, Mesh& mesh)
{
  struct Side
  {
    std::array<int, 3> Surface; // materials, the smaller first, and side of the domain
    Index Element;
    int Face;
  };
  std::vector<Side> sides;
  std::map<std::array<int, 3>, int> surfaces;
  for (Index e = 0; e < cells.NumberOfCells(); ++e)
  {
    const Index3 cell = CellInBox(cells, e);
    for (int face = 0; face < 6; ++face)
    {
      Index3 next = cell;
      next[face / 2] += face % 2 ? 1 : -1;
      const bool isInside = grid.InDomain(next);
      const int own = materialOf(cell), other = isInside ? materialOf(next) : 0;
      if (isInside ? other < own : own > 0)
      {
        sides.push_back({ { { other, own, isInside ? -1 : face } }, e, face });
        surfaces[sides.back().Surface] = 0;
      }
    }
  }
  for (auto& surface : surfaces)
  {
    surface.second = static_cast<int>(mesh.Tables.SurfaceVolumes.size()) + 1;
    const GeometryTables::Pair pair{ { surface.first[0], surface.first[1] } };
    mesh.Tables.SurfaceVolumes.push_back(pair);
    mesh.Tables.SurfaceMaterials.push_back(pair);
    mesh.Tables.SurfaceSides.push_back(surface.first[2]);
    mesh.Tables.SurfaceParts.push_back(0);
  }
  SurfaceFacets& facets = mesh.Surfaces;
  facets.Points = Buffer<Index>(4 * sides.size());
  facets.SurfaceId = Buffer<int>(sides.size());
  facets.MaterialPair = Buffer<int>(2 * sides.size());
  facets.DomainSide = Buffer<int>(sides.size());
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const Side& side = sides[s];
    const int id = surfaces[side.Surface];
    facets.SurfaceId[s] = id;
    facets.DomainSide[s] = side.Surface[2];
    std::copy_n(side.Surface.data(), 2, facets.MaterialPair.data() + 2 * s);
    facets.IsOwned.push_back(grid.Owned().Contains(CellInBox(cells, side.Element)));
    for (int c = 0; c < 4; ++c)
    {
      const Index point = mesh.Elements[8 * side.Element + VtkCorner[FaceCorners[side.Face][c]]];
      facets.Points[4 * s + c] = point;
      const bool isFirst = mesh.GeometryDimension[point] == 3;
      mesh.GeometryDimension[point] = isFirst || mesh.GeometryId[point] == id ? 2 : 1;
      mesh.GeometryId[point] = isFirst ? id : mesh.GeometryId[point];
    }
  }
}

/// Returns the hexes of the cells of CartesianGrid::HexBox. Fragments have the numbers of
/// materials.
/// @pre Collective.
inline Mesh MakeCellMesh(
  const CartesianGrid& grid, Ranks& ranks, const std::function<int(const Index3&)>& materialOf)
{
  Mesh mesh;
  mesh.Levels = std::make_shared<const RefinedGrid>(grid, ranks);
  const IndexBox cells = grid.HexBox();
  IndexBox nodes = cells;
  for (Index& upper : nodes.Upper)
  {
    ++upper;
  }
  mesh.ResizePoints(nodes.NumberOfCells());
  mesh.GeometryDimension = Buffer<int>(nodes.NumberOfCells());
  mesh.GeometryId = Buffer<int>(nodes.NumberOfCells());
  for (Index p = 0; p < nodes.NumberOfCells(); ++p)
  {
    const Index3 node = CellInBox(nodes, p);
    mesh.SetPoint(p, grid.NodePoint(node), grid.NodeKey(node) * HexIds.PointSlots + 1);
    mesh.GeometryDimension[p] = 3;
    mesh.GeometryId[p] = 1;
  }
  mesh.ResizeElements(cells.NumberOfCells());
  mesh.Fragment = Buffer<int>(cells.NumberOfCells());
  for (Index e = 0; e < cells.NumberOfCells(); ++e)
  {
    const Index3 cell = CellInBox(cells, e);
    std::array<Index, 8> corners;
    for (int c = 0; c < 8; ++c)
    {
      corners[c] = IndexInBox(nodes, CornerOfCell(cell, c));
    }
    const int material = materialOf(cell);
    mesh.SetElement(e, InVtkOrder(corners), grid.CellKey(cell) * HexIds.ElementSlots + 1, material);
    mesh.Fragment[e] = material;
  }
  AddCellFacets(grid, cells, materialOf, mesh);
  return mesh;
}

} // namespace testing
} // namespace vfm
