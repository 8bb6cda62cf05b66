/// Sides of elements that are facets.
#include "Elements/FacetSides.h"
#include "CellMesh.h"
#include "MeshChecks.h"

#include <gtest/gtest.h>

#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Material 1 below x = 1, material 2 in the two other layers, of 3 x 2 x 1 cells.
Mesh MakeTwoMaterials(const CartesianGrid& grid, Runtime& runtime)
{
  return MakeCellMesh(
    grid, runtime.Group(), [](const Index3& cell) { return cell[0] < 1 ? 1 : 2; });
}

} // namespace

TEST(FacetSides, OfTwoMaterials)
{
  const CartesianGrid grid = MakeUnitGrid(3, 2, 1);
  Runtime runtime;
  const Mesh mesh = MakeTwoMaterials(grid, runtime);
  const std::vector<FacetSide> sides = ListFacetSides(mesh, runtime);
  // The surface of the box has 22 faces; the two faces between the materials have two sides.
  EXPECT_EQ(sides.size(), 22u + 2u * 2u);
  const std::vector<MeshFacet> facets = FindElements(sides, mesh, runtime);
  ASSERT_EQ(facets.size(), sides.size());
  EXPECT_TRUE(std::is_sorted(facets.begin(), facets.end()));
  std::set<std::array<Index, 2>> found;
  for (const MeshFacet& facet : facets)
  {
    const Index3 cell = CellInBox(grid.Global(), facet.Element);
    Index3 next = cell;
    next[facet.Side / 2] += facet.Side % 2 ? 1 : -1;
    const bool isInside = grid.InDomain(next);
    EXPECT_EQ(facet.Behind, isInside ? (next[0] < 1 ? 1 : 2) : NothingBehind);
    EXPECT_EQ(facet.DomainSide, isInside ? -1 : facet.Side);
    EXPECT_EQ(facet.Surface, 0);
    EXPECT_NE(facet.Behind, mesh.Material[facet.Element]);
    found.insert({ { facet.Element, facet.Side } });
  }
  EXPECT_EQ(found.size(), facets.size());
}

TEST(FacetSides, PointsOfFacetsFindTheirElements)
{
  const CartesianGrid grid = MakeUnitGrid(3, 2, 1);
  Runtime runtime;
  Mesh mesh = MakeTwoMaterials(grid, runtime);
  mesh.Facets = FindElements(ListFacetSides(mesh, runtime), mesh, runtime);
  const std::vector<FacetSide> sides = ListPointsOfFacets(mesh);
  for (const FacetSide& side : sides)
  {
    // The points of a facet have the coordinate of its side.
    const int axis = side.Facet.Side / 2;
    const Index3 cell = CellInBox(grid.Global(), side.Facet.Element);
    for (Index point : side.Points)
    {
      EXPECT_EQ(mesh.PointAt(point)[axis], static_cast<double>(cell[axis] + side.Facet.Side % 2));
    }
  }
  const std::vector<MeshFacet> again = FindElements(sides, mesh, runtime);
  ASSERT_EQ(again.size(), mesh.Facets.size());
  for (std::size_t f = 0; f < again.size(); ++f)
  {
    EXPECT_EQ(ElementSide(again[f]), ElementSide(mesh.Facets[f]));
    EXPECT_EQ(again[f].Behind, mesh.Facets[f].Behind);
  }
}

TEST(FacetSides, SmoothSidesHaveTheirSurface)
{
  const CartesianGrid grid = MakeUnitGrid(3, 2, 1);
  Runtime runtime;
  Mesh mesh = MakeTwoMaterials(grid, runtime);
  const GeometryTables::Pair interface {
    {
      1, 2
    }
  };
  const auto at =
    std::find(mesh.Tables.SurfaceVolumes.begin(), mesh.Tables.SurfaceVolumes.end(), interface);
  const auto surface = static_cast<int>(at - mesh.Tables.SurfaceVolumes.begin());
  mesh.Tables.SurfaceParts[surface] = 1;
  int interfaces = 0;
  for (const FacetSide& side : ListFacetSides(mesh, runtime))
  {
    interfaces += side.Facet.Surface == surface + 1;
    EXPECT_EQ(side.Facet.Surface > 0, side.Facet.DomainSide < 0);
  }
  EXPECT_EQ(interfaces, 4);
}
