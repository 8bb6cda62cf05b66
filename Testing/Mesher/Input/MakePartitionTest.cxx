/// One box of cells per rank, balanced by interface cells.
#include "Input/MakePartition.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

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

/// Returns the partition, the same on every rank, if rank r has blocks[r]
/// and the cells inside them.
std::vector<IndexBox> Partition(const IndexBox& global,
  const std::vector<std::vector<IndexBox>>& blocks, const std::vector<Index3>& cells)
{
  std::vector<std::vector<IndexBox>> found(blocks.size());
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
  for (const auto& boxes : found)
  {
    EXPECT_TRUE(boxes == found[0]);
  }
  return found[0];
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
