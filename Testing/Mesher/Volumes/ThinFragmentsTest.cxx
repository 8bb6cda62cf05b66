/// Which fragments have thin parts.
#include "Volumes/ThinFragments.h"
#include "FragmentShares.h"
#include "MeshChecks.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(ThinFragments, HaveElementsInThinCells)
{
  const CartesianGrid grid = MakeUnitGrid(12, 4, 4);
  const FractionField two =
    MakeLabels(grid, 1, [](const Index3& p) { return p[0] < 3 || p[0] > 7 ? 1 : 0; });
  MeshOptions options;
  options.StairStep = true;
  const Mesh mesh = MakeCells(grid, two, options);
  Runtime runtime;
  const auto find = [&](const std::vector<Index>& thin)
  { return FindThinFragments(grid, mesh, thin, ShareOfAll(2, runtime.Group())); };
  EXPECT_TRUE(find({}).empty());
  const std::vector<unsigned char> isThin = find({ grid.Linear({ { 9, 1, 2 } }) });
  ASSERT_EQ(isThin.size(), 3u);
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    const Index3 cell = CellOfElement(grid, mesh, mesh.ElementIds[e]);
    EXPECT_EQ(isThin[mesh.Fragment[e]], cell[0] > 7);
  }
}

/// Elements outside of fragments count on all ranks if those of one rank are in thin cells.
TEST(ThinFragments, OutsideIsTheSameOnRanks)
{
  const CartesianGrid grid = MakeUnitGrid(12, 4, 4);
  const FractionField one = MakeLabels(grid, 1, [](const Index3&) { return 1; });
  MeshOptions options;
  options.StairStep = true;
  Mesh mesh = MakeCells(grid, one, options);
  std::fill(mesh.Fragment.begin(), mesh.Fragment.end(), 0);
  RunOnRanks(3,
    [&](Ranks& ranks)
    {
      const std::vector<Index> thin(ranks.Rank() == 1, grid.Linear({ { 9, 1, 2 } }));
      const auto isThin = FindThinFragments(grid, mesh, thin, ShareOfAll(1, ranks));
      EXPECT_EQ(isThin, (std::vector<unsigned char>{ 1, 0 }));
    });
}
