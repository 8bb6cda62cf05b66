/// Sums by cell and material.
#include "Volumes/CellVolumes.h"
#include "MeshChecks.h"
#include "RankFields.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Materials = 3;

/// Returns the amounts of a material in the cells of a grid, with (x, y, z, material) as key.
std::map<std::array<Index, 4>, std::array<std::int64_t, 3>> ListAmounts(
  const CellVolumes& volumes, const IndexBox& cells)
{
  std::map<std::array<Index, 4>, std::array<std::int64_t, 3>> amounts;
  ForCells(cells,
    [&](const Index3& p)
    {
      for (int m = 0; m < Materials; ++m)
      {
        volumes.ForRow(p, 1, m,
          [&](Index, const CellVolumes::Amounts& a) {
            amounts[{ p[0], p[1], p[2], m }] = { a.Lack, a.Filled, a.Area };
          });
      }
    });
  return amounts;
}

} // namespace

TEST(CellVolumes, AmountsOfACellAreAdded)
{
  const CartesianGrid grid = MakeUnitGrid(4);
  CellVolumes volumes(grid, Materials);
  const Index cell = grid.Linear({ { 1, 2, 3 } }), other = grid.Linear({ { 3, 2, 3 } });
  volumes.Add(cell, 1, { 5, 6, 7 });
  volumes.Add(other, 2, { 1, 1, 1 });
  volumes.Add(cell, 2, { 2, 0, 0 });
  volumes.Add({ { volumes.KeyOf(cell, 1), { -1, 1, 3 } } });
  volumes.Unite();
  const std::map<std::array<Index, 4>, std::array<std::int64_t, 3>> expected{ { { 1, 2, 3, 1 },
                                                                                { 4, 7, 10 } },
    { { 1, 2, 3, 2 }, { 2, 0, 0 } }, { { 3, 2, 3, 2 }, { 1, 1, 1 } } };
  EXPECT_EQ(ListAmounts(volumes, grid.Global()), expected);
  EXPECT_EQ(CellVolumes::Rounded(0.25), std::int64_t(1) << 38);
}

TEST(CellVolumes, RowsEndAtTheLocalBox)
{
  const CartesianGrid grid = MakeUnitGrid(4);
  CellVolumes volumes(grid, Materials);
  for (Index i = 0; i < 4; ++i)
  {
    volumes.Add(grid.Linear({ { i, 1, 1 } }), 1, { i + 1, 0, 0 });
    volumes.Add(grid.Linear({ { i, 2, 1 } }), 1, { 100, 0, 0 });
  }
  volumes.Unite();
  const auto list = [&](const Index3& first, Index count)
  {
    std::vector<std::array<Index, 2>> row;
    volumes.ForRow(first, count, 1,
      [&](Index i, const CellVolumes::Amounts& a) {
        row.push_back({ i, a.Lack });
      });
    return row;
  };
  using Row = std::vector<std::array<Index, 2>>;
  EXPECT_EQ(list({ { -2, 1, 1 } }, 4), (Row{ { 2, 1 }, { 3, 2 } }));
  EXPECT_EQ(list({ { 2, 1, 1 } }, 4), (Row{ { 0, 3 }, { 1, 4 } }));
  EXPECT_EQ(list({ { 1, 1, 1 } }, 2), (Row{ { 0, 2 }, { 1, 3 } }));
  EXPECT_EQ(list({ { 0, -1, 1 } }, 4), Row());
  EXPECT_EQ(list({ { 0, 1, 4 } }, 4), Row());
  EXPECT_EQ(list({ { 5, 1, 1 } }, 4), Row());
}

/// Ranks that add to all cells that they hold get the sums of all ranks.
TEST(CellVolumes, CompleteOnRanks)
{
  const CartesianGrid whole = MakeUnitGrid(12, 7, 5);
  const std::vector<IndexBox> boxes = CutBox(whole.Global(), 5);
  CellVolumes all(whole, Materials);
  const auto amountsOf = [](const Index3& p, int material, std::size_t rank)
  {
    const std::int64_t number = p[0] + 100 * p[1] + 10000 * p[2];
    return CellVolumes::Amounts{ number * (static_cast<int>(rank) + 1), material, 1 };
  };
  const auto add = [&](std::size_t rank, const CartesianGrid& grid, CellVolumes& volumes)
  {
    ForCells(Grow(boxes[rank], 1, whole.Global()),
      [&](const Index3& p)
      {
        const int material = static_cast<int>(1 + (p[0] + rank) % 2);
        volumes.Add(grid.Linear(p), material, amountsOf(p, material, rank));
      });
  };
  for (std::size_t rank = 0; rank < boxes.size(); ++rank)
  {
    add(rank, whole, all);
  }
  all.Unite();
  RunOnRanks(static_cast<int>(boxes.size()),
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
      CellVolumes mine(grid, Materials);
      add(ranks.Rank(), grid, mine);
      mine.Unite();
      mine.Complete(Partition(grid, ranks));
      EXPECT_EQ(ListAmounts(mine, grid.Local()), ListAmounts(all, grid.Local()));
    });
}
