/// One box of cells per rank, balanced by interface cells.
#include "Input/MakePartition.h"
#include "RandomDraw.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

IndexBox MakeBox(const Index3& lower, const Index3& upper)
{
  IndexBox box;
  box.Lower = lower;
  box.Upper = upper;
  return box;
}

/// Returns the box of each rank, if rank r has blocks[r] and the cells inside them.
std::vector<IndexBox> Partition(const IndexBox& global,
  const std::vector<std::vector<IndexBox>>& blocks, const std::vector<Index3>& cells)
{
  std::vector<IndexBox> found(blocks.size());
  RunOnRanks(static_cast<int>(blocks.size()),
    [&](Ranks& ranks)
    {
      const std::vector<IndexBox>& mine = blocks[ranks.Rank()];
      const auto findCells = [&]
      {
        std::vector<Index3> held;
        for (const Index3& cell : cells)
        {
          for (const IndexBox& block : mine)
          {
            if (block.Contains(cell))
            {
              held.push_back(cell);
            }
          }
        }
        return held;
      };
      found[ranks.Rank()] = MakePartition(global, mine, findCells, ranks);
    });
  return found;
}

/// Returns the weights of the planes of a box across an axis, each cell with its weight.
std::vector<double> WeighPlanes(const IndexBox& box, int axis, const std::vector<Index3>& cells)
{
  std::vector<double> planes(box.Size(axis));
  ForCells(box, [&](const Index3& cell) { planes[cell[axis] - box.Lower[axis]] += CellWeight; });
  for (const Index3& cell : cells)
  {
    if (box.Contains(cell))
    {
      planes[cell[axis] - box.Lower[axis]] += InterfaceCellWeight;
    }
  }
  return planes;
}

/// Cuts a box for the ranks from `first` on, from the weights of the whole grid.
void CutWhole(const IndexBox& box, int first, int count, const std::vector<Index3>& cells,
  std::vector<IndexBox>& boxes)
{
  if (count == 1)
  {
    boxes[first] = box;
    return;
  }
  int axis = box.Size(1) > box.Size(0) ? 1 : 0;
  axis = box.Size(2) > box.Size(axis) ? 2 : axis;
  const std::vector<double> planes = WeighPlanes(box, axis, cells);
  const double share = static_cast<double>(count / 2) / count,
               total = std::accumulate(planes.begin(), planes.end(), 0.0);
  Index cut = std::min<Index>(box.Size(axis), 1);
  double sum = 0.0, least = std::numeric_limits<double>::infinity();
  for (Index x = 1; x < box.Size(axis); ++x)
  {
    sum += planes[x - 1];
    if (std::abs(sum - share * total) < least)
    {
      least = std::abs(sum - share * total);
      cut = x;
    }
  }
  IndexBox lower = box, upper = box;
  lower.Upper[axis] = upper.Lower[axis] = box.Lower[axis] + cut;
  CutWhole(lower, first, count / 2, cells, boxes);
  CutWhole(upper, first + count / 2, count - count / 2, cells, boxes);
}

void ExpectTiling(const IndexBox& global, const std::vector<IndexBox>& boxes)
{
  Index cells = 0;
  for (std::size_t a = 0; a < boxes.size(); ++a)
  {
    cells += boxes[a].NumberOfCells();
    EXPECT_EQ(Intersect(boxes[a], global).NumberOfCells(), boxes[a].NumberOfCells());
    for (std::size_t b = 0; b < a; ++b)
    {
      EXPECT_EQ(Intersect(boxes[a], boxes[b]).NumberOfCells(), 0);
    }
  }
  EXPECT_EQ(cells, global.NumberOfCells());
}

} // namespace

TEST(MakePartition, AllDataOnOneRank)
{
  const IndexBox global = MakeBox({ { 0, 0, 0 } }, { { 20, 10, 8 } });
  for (std::size_t count : { 2u, 3u, 5u, 8u })
  {
    std::vector<std::vector<IndexBox>> blocks(count);
    blocks[count - 1] = { global };
    const std::vector<IndexBox> boxes = Partition(global, blocks, {});
    ASSERT_EQ(boxes.size(), count);
    ExpectTiling(global, boxes);
    for (const IndexBox& box : boxes)
    {
      EXPECT_LE(box.NumberOfCells() * static_cast<Index>(count), global.NumberOfCells() * 7 / 5);
    }
  }
}

TEST(MakePartition, InterfaceCellsWeighMore)
{
  const IndexBox global = MakeBox({ { 0, 0, 0 } }, { { 16, 4, 4 } });
  std::vector<Index3> cells;
  for (Index n = 0; n < 64; ++n) // all interfaces in the first four layers
  {
    cells.push_back({ { n / 16, n / 4 % 4, n % 4 } });
  }
  const std::vector<IndexBox> boxes = Partition(global, { { global }, {} }, cells);
  ExpectTiling(global, boxes);
  EXPECT_LE(boxes[0].Size(0), 3);
}

TEST(MakePartition, BalancedBoxesStay)
{
  const IndexBox global = MakeBox({ { 0, 0, 0 } }, { { 12, 4, 4 } });
  const IndexBox low = MakeBox({ { 0, 0, 0 } }, { { 7, 4, 4 } });
  const IndexBox high = MakeBox({ { 7, 0, 0 } }, { { 12, 4, 4 } });
  EXPECT_TRUE((Partition(global, { { high }, { low } }, {}) == std::vector<IndexBox>{ high, low }));
}

TEST(MakePartition, MoreRanksThanCells)
{
  const IndexBox global = MakeBox({ { 0, 0, 0 } }, { { 2, 1, 1 } });
  std::vector<std::vector<IndexBox>> blocks(5);
  blocks[0] = { global };
  const std::vector<IndexBox> boxes = Partition(global, blocks, {});
  ASSERT_EQ(boxes.size(), 5u);
  ExpectTiling(global, boxes);
}

TEST(MakePartition, CutsOfTheWholeGrid)
{
  for (int count : { 2, 3, 5, 7, 8, 13, 27, 64 })
  {
    RandomDraw draw(count);
    IndexBox global;
    for (Index& size : global.Upper)
    {
      size = draw.Whole(1, 40);
    }
    std::vector<Index3> cells; // in one corner, some of them twice
    for (int n = draw.Whole(0, 3000); n > 0; --n)
    {
      Index3 cell;
      for (int a = 0; a < 3; ++a)
      {
        cell[a] = draw.Whole(0, static_cast<int>(global.Upper[a] * (1 + n % 2) - 1) / 2);
      }
      cells.push_back(cell);
    }
    std::vector<std::vector<IndexBox>> blocks(count); // rows of cells of any ranks
    ForRows(global,
      [&](Index j, Index k)
      {
        blocks[draw.Whole(0, draw.Chance(0.5) ? count - 1 : 0)].push_back(
          MakeBox({ { 0, j, k } }, { { global.Upper[0], j + 1, k + 1 } }));
      });
    std::vector<IndexBox> expected(count);
    CutWhole(global, 0, count, cells, expected);
    EXPECT_TRUE(Partition(global, blocks, cells) == expected) << count;
  }
}
