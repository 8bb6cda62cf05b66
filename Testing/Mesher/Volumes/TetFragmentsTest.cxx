/// Fragments of tets.
#include "Volumes/TetFragments.h"
#include "Elements/Tet/CellTets.h"
#include "MeshChecks.h"
#include "NoCoarseTets.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Material 2 divides material 1 along x.
int MaterialOf(const Index3& cell)
{
  return cell[0] >= 2 && cell[0] < 4 ? 2 : 1;
}

} // namespace

TEST(TetFragments, AreConnectedTets)
{
  const CartesianGrid whole = MakeUnitGrid(8, 3, 3);
  for (int count : { 1, 2 })
  {
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), count, 1);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        RankRuntime runtime(ranks);
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        const Partition partition(grid, ranks);
        const FractionField fractions = MakeLabels(grid, 2, MaterialOf);
        const LabelArray labels = AssignMaterials(grid, fractions, 0.5);
        TetTopology topology =
          BuildCellTets(labels, false, NarrowVoid(), runtime, NoCoarseTets(grid, runtime).Tets);
        const Mesh& mesh = topology.Tets;
        const TetFaces faces = FindTetFaces(mesh, topology.Positions, topology.Barrier, grid);
        const TetFragments fragments(topology, faces, grid, partition);
        // By their lowest tets: below x = 2, at 2 to 4, and above.
        EXPECT_EQ(fragments.Share().Materials, (std::vector<int>{ 0, 1, 2, 1 }));
        for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
        {
          double x = 0.0;
          for (int c = 0; c < 4; ++c)
          {
            x += 0.25 * mesh.PointAt(mesh.Elements[4 * t + c])[0];
          }
          ASSERT_EQ(mesh.Fragment[t], x < 2.0 ? 1 : x < 4.0 ? 2 : 3);
        }
        const Index3& at = grid.Owned().Lower;
        std::vector<std::array<Index, 3>> runs;
        fragments.ForRuns(at[1], at[2],
          [&](Index first, Index last, int fragment) {
            runs.push_back({ { first, last, fragment } });
          });
        EXPECT_EQ(runs,
          (std::vector<std::array<Index, 3>>{ { { 0, 2, 1 } }, { { 2, 4, 2 } }, { { 4, 8, 3 } } }));
        const auto findNear = [&](Index i, int material) {
          return fragments.FindNear({ { i, at[1], at[2] } }, material);
        };
        EXPECT_EQ(findNear(0, 1), 1);
        EXPECT_EQ(findNear(2, 1), 1);
        EXPECT_EQ(findNear(3, 1), 3);
        EXPECT_EQ(findNear(4, 2), 2);
        EXPECT_EQ(findNear(7, 1), 3);
      });
  }
}
