/// Numbers and quality of elements, and the elements that a rank keeps.
#include "Geometry/MeasureMaterials.h"
#include "CellMesh.h"
#include "Geometry/KeepOwned.h"
#include "MeshChecks.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(MeasureMaterials, SumsOverRanks)
{
  RunOnRanks(2,
    [](Ranks& ranks)
    {
      Mesh mesh;
      const bool isFirst = ranks.Rank() == 0;
      const std::vector<int> materials =
        isFirst ? std::vector<int>{ 1, 1, 3 } : std::vector<int>{ 3, 1, 1 };
      const std::vector<float> quality = isFirst ? std::vector<float>{ 1.0f, 0.5f, 1.0f }
                                                 : std::vector<float>{ 0.75f, 1.0f, -0.25f };
      mesh.Material = Buffer<int>(3);
      mesh.ScaledJacobian = Buffer<float>(3);
      std::copy(materials.begin(), materials.end(), mesh.Material.begin());
      std::copy(quality.begin(), quality.end(), mesh.ScaledJacobian.begin());
      MeshReport report;
      report.Materials.resize(4);
      MeasureMaterials(mesh, ranks, report);
      const std::vector<MeshReport::Material>& found = report.Materials;
      EXPECT_EQ(found[0].Elements, 0);
      EXPECT_EQ(found[1].Elements, 4);
      EXPECT_EQ(found[1].MinimumScaledJacobian, -0.25);
      EXPECT_EQ(found[1].MeanScaledJacobian, (1.0 + 0.5 + 1.0 - 0.25) / 4);
      EXPECT_EQ(found[2].Elements, 0);
      EXPECT_EQ(found[2].MeanScaledJacobian, 0.0);
      EXPECT_EQ(found[3].Elements, 2);
      EXPECT_EQ(found[3].MinimumScaledJacobian, 0.75);
      EXPECT_EQ(found[3].MeanScaledJacobian, 0.875);
    });
}

TEST(MeasureMaterials, WithoutQualityOnlyCounts)
{
  Runtime runtime;
  const Mesh mesh = MakeCellMesh(
    MakeUnitGrid(2, 1, 1), runtime.Group(), [](const Index3& cell) { return cell[0] < 1 ? 1 : 2; });
  MeshReport report;
  report.Materials.resize(3);
  MeasureMaterials(mesh, runtime.Group(), report);
  EXPECT_EQ(report.Materials[2].Elements, 1);
  EXPECT_EQ(report.Materials[2].MeanScaledJacobian, 0.0);
}

/// Each rank keeps the hexes of its cells, their points and facets.
TEST(KeepOwned, RanksKeepTheirCells)
{
  const CartesianGrid whole = MakeUnitGrid(6, 2, 2);
  const std::vector<IndexBox> boxes = CutBox(whole.Global(), 2, 0);
  RunOnRanks(2,
    [&](Ranks& ranks)
    {
      RankRuntime runtime(ranks);
      const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
      Mesh mesh = MakeCellMesh(grid, ranks, [](const Index3& cell) { return cell[0] < 2 ? 1 : 2; });
      ASSERT_EQ(mesh.ElementIds.size(), 5u * 2 * 2); // two layers of ghosts
      Index whole5 = 5;
      KeepOwned(grid, BarrierElements(), runtime, whole5, mesh);
      ASSERT_EQ(mesh.ElementIds.size(), 3u * 2 * 2);
      // Of the first row of five hexes, three are owned.
      EXPECT_EQ(whole5, 3);
      EXPECT_EQ(mesh.PointIds.size(), 4u * 3 * 3);
      for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
      {
        const Index3 cell = CellOfElement(grid, mesh, mesh.ElementIds[e]);
        EXPECT_TRUE(grid.Owned().Contains(cell));
        EXPECT_EQ(mesh.Material[e], cell[0] < 2 ? 1 : 2);
        const Vector3 first = mesh.PointAt(mesh.Elements[8 * e]);
        EXPECT_EQ(first, grid.NodePoint(cell));
      }
      // Three sides of 3 x 2, twice, and one end of 2 x 2; the interface is on rank 0.
      const std::size_t outside = 4u * 6 + 4, interfaces = ranks.Rank() == 0 ? 4 : 0;
      EXPECT_EQ(mesh.Surfaces.SurfaceId.size(), outside + interfaces);
      EXPECT_EQ(mesh.Facets.size(), outside + 2 * interfaces);
    });
}

/// Elements of the barrier, which are void, go with the points that only they have.
TEST(KeepOwned, BarrierGoes)
{
  const CartesianGrid grid = MakeUnitGrid(3, 1, 1);
  Runtime runtime;
  BarrierElements barrier;
  barrier.Exist = true;
  Mesh mesh = MakeCellMesh(grid, runtime.Group(), [](const Index3& cell) { return cell[0] != 2; });
  Index wholeCells = 3;
  KeepOwned(grid, barrier, runtime, wholeCells, mesh);
  EXPECT_EQ(mesh.ElementIds.size(), 2u);
  EXPECT_EQ(mesh.PointIds.size(), 12u);
  EXPECT_EQ(wholeCells, 2);
  EXPECT_EQ(mesh.Facets.size(), 10u);
}
