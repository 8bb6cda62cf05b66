/// Points and edges where surfaces meet, and the measures of surfaces.
#include "Geometry/Junctions.h"
#include "CellMesh.h"
#include "Geometry/MeasureSurfaces.h"
#include "MeshChecks.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

Mesh MakeBox(const CartesianGrid& grid, Ranks& ranks)
{
  return MakeCellMesh(grid, ranks, [](const Index3&) { return 1; });
}

} // namespace

/// A box of 3 x 2 x 1 cells has six surfaces.
TEST(Junctions, OfABox)
{
  const CartesianGrid grid = MakeUnitGrid(3, 2, 1);
  Runtime runtime;
  const Mesh mesh = MakeBox(grid, runtime.Group());
  const Junctions junctions(mesh);
  // Edges of the box: four times 3, 2 and 1 edges of cells.
  EXPECT_EQ(junctions.Edges().size(), 4u * (3 + 2 + 1));
  for (const Junction& edge : junctions.Edges())
  {
    EXPECT_LT(edge.Points[0], edge.Points[1]);
    EXPECT_EQ(edge.Surfaces.size(), 2u);
  }
  std::size_t vertices = 0;
  EXPECT_EQ(junctions.Points().size(), 8u + 4u * (2 + 1));
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    const Junction& point = junctions.Points()[p];
    const Vector3 x = mesh.PointAt(point.Points[0]);
    const bool isCorner = (x[0] == 0.0 || x[0] == 3.0) && (x[1] == 0.0 || x[1] == 2.0);
    EXPECT_EQ(junctions.IsVertex(p), isCorner);
    EXPECT_EQ(point.Surfaces.size(), isCorner ? 3u : 2u);
    EXPECT_EQ(junctions.Find(point.Points[0]), p);
    vertices += junctions.IsVertex(p);
  }
  EXPECT_EQ(vertices, 8u);
}

/// The first facet is the one with the lowest points, wherever it is in the list.
TEST(Junctions, FirstFacetHasTheLowestPoints)
{
  const CartesianGrid grid = MakeUnitGrid(1, 1, 1);
  Runtime runtime;
  Mesh mesh = MakeBox(grid, runtime.Group());
  const Junctions junctions(mesh);
  for (const Junction& edge : junctions.Edges())
  {
    std::vector<std::array<Index, 4>> keys;
    for (std::size_t f = 0; f < 6; ++f)
    {
      std::array<Index, 4> key;
      std::copy_n(mesh.Surfaces.Points.data() + 4 * f, 4, key.begin());
      std::sort(key.begin(), key.end());
      const bool isAdjacent =
        std::includes(key.begin(), key.end(), edge.Points.begin(), edge.Points.end());
      keys.push_back(isAdjacent ? key : std::array<Index, 4>{ { 9, 9, 9, 9 } });
    }
    EXPECT_EQ(edge.First, std::min_element(keys.begin(), keys.end()) - keys.begin());
  }
}

TEST(MeasureSurfaces, OfABoxOnRanks)
{
  std::array<std::vector<double>, 3> x;
  x[0] = { 1.0, 2.0, 4.0, 5.0 };
  x[1] = { -1.0, 1.0, 2.0 };
  x[2] = { 0.0, 3.0 };
  const CartesianGrid whole(x);
  const double size[] = { 4.0, 3.0, 3.0 };
  const Vector3 centre{ { 3.0, 0.5, 1.5 } };
  for (int count : { 1, 3 })
  {
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), count, 0);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        RankRuntime runtime(ranks);
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        Mesh mesh = MakeBox(grid, ranks);
        // Ranks at one end of the box lack the surface of the other.
        for (std::size_t f = 0; f < mesh.Surfaces.IsOwned.size(); ++f)
        {
          mesh.Surfaces.SurfaceId[f] = mesh.Surfaces.DomainSide[f] + 1;
        }
        const std::vector<unsigned char> areShared(6, count > 1);
        MeasureSurfaces({ 1, 2, 3, 4, 5, 6 }, areShared, mesh, runtime);
        for (int side = 0; side < 6; ++side)
        {
          const int axis = side / 2;
          EXPECT_NEAR(
            mesh.Tables.SurfaceAreas[side], size[(axis + 1) % 3] * size[(axis + 2) % 3], 1e-12);
          for (int a = 0; a < 3; ++a)
          {
            const double outward = side % 2 ? 1.0 : -1.0;
            EXPECT_NEAR(mesh.Tables.SurfaceNormals[side][a], a == axis ? outward : 0.0, 1e-12);
            EXPECT_NEAR(mesh.Tables.SurfaceCentroids[side][a],
              centre[a] + (a == axis ? 0.5 * outward * size[a] : 0.0), 1e-12);
          }
        }
      });
  }
}
