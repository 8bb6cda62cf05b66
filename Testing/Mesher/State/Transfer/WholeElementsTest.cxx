/// Elements that consist of whole cells.
#include "State/Transfer/WholeElements.h"
#include "CellMesh.h"
#include "MeshChecks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

int MaterialOf(const Index3& cell)
{
  return cell[0] < 2 ? 1 : 2;
}

} // namespace

TEST(WholeElements, HaveTheirCornersAndPureCells)
{
  const CartesianGrid grid = MakeUnitGrid(4, 3, 3);
  Runtime runtime;
  Mesh mesh = MakeCellMesh(grid, runtime.Group(), MaterialOf);
  FractionField fractions = MakeLabels(grid, 2, MaterialOf);
  const Index3 mixed{ { 3, 0, 1 } }, other{ { 0, 2, 2 } };
  fractions.SetParts(grid.Linear(mixed), { { 1, 1e-9 }, { 2, 1.0 - 1e-9 } });
  fractions.SetLabel(grid.Linear(other), 2);
  // A moved corner changes the eight elements around node (2, 1, 1).
  const Index node = 2 + 5 * (1 + 4 * 1);
  mesh.Points[3 * node + 2] += 1e-12;
  const WholeElements whole(mesh, grid, fractions, runtime);
  ASSERT_TRUE(whole.CanExist());
  int count = 0;
  for (Index e = 0; e < grid.Global().NumberOfCells(); ++e)
  {
    const Index3 cell = CellInBox(grid.Global(), e);
    const bool isMoved = (cell[0] == 1 || cell[0] == 2) && cell[1] < 2 && cell[2] < 2;
    const bool isWhole = !isMoved && cell != mixed && cell != other;
    EXPECT_EQ(whole.IsWhole(e), isWhole) << TextOf(cell);
    EXPECT_EQ(whole.Covers(grid.Linear(cell)), isWhole);
    count += isWhole;
    if (isWhole)
    {
      EXPECT_EQ(whole.CellsOf(e), BoxOfCell(cell));
    }
  }
  EXPECT_EQ(count, 36 - 8 - 2);
}

/// An element of 2 x 2 x 1 cells is whole if all of them are pure.
TEST(WholeElements, CoverSeveralCells)
{
  const CartesianGrid grid = MakeUnitGrid(4, 3, 3);
  Runtime runtime;
  Mesh mesh = MakeCellMesh(grid, runtime.Group(), MaterialOf);
  const IndexBox nodes{ {}, { { 5, 4, 4 } } };
  for (int c = 0; c < 8; ++c)
  {
    const Index3 node{ { 2 * (c & 1), 2 * (c >> 1 & 1), c >> 2 } };
    mesh.Elements[VtkCorner[c]] = IndexInBox(nodes, node);
  }
  FractionField fractions = MakeLabels(grid, 2, MaterialOf);
  const WholeElements whole(mesh, grid, fractions, runtime);
  ASSERT_TRUE(whole.IsWhole(0));
  EXPECT_EQ(whole.CellsOf(0), (IndexBox{ {}, { { 2, 2, 1 } } }));
  fractions.SetLabel(grid.Linear({ { 1, 1, 0 } }), 2);
  EXPECT_FALSE(WholeElements(mesh, grid, fractions, runtime).IsWhole(0));
}

TEST(WholeElements, TetsAreNone)
{
  const CartesianGrid grid = MakeUnitGrid(2);
  Runtime runtime;
  Mesh mesh;
  mesh.Corners = 4;
  mesh.ResizeElements(1);
  const FractionField fractions = MakeLabels(grid, 1, [](const Index3&) { return 1; });
  const WholeElements whole(mesh, grid, fractions, runtime);
  EXPECT_FALSE(whole.CanExist());
  EXPECT_FALSE(whole.IsWhole(0));
}
