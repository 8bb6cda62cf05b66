/// Cells near interfaces or on sides of the domain.
#include "Elements/Hex/NearCells.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using vfm::testing::RandomDraw;

namespace
{

constexpr Index Side = 18, Rings = 2;

CartesianGrid MakeGrid(const IndexBox& owned, int ghostLayers)
{
  std::vector<double> x(Side + 1);
  std::iota(x.begin(), x.end(), 0.0);
  return { std::array<std::vector<double>, 3>{ { x, x, x } }, owned, ghostLayers };
}

bool IsNear(const CartesianGrid& grid, const std::vector<Index>& mixed, const Index3& cell)
{
  bool isNear = false;
  for (int a = 0; a < 3; ++a)
  {
    isNear = isNear || cell[a] == 0 || cell[a] == Side - 1;
  }
  for (Index node : mixed)
  {
    const Index3 p = grid.Position(node);
    bool isWithin = true;
    for (int a = 0; a < 3; ++a)
    {
      isWithin = isWithin && p[a] - Rings <= cell[a] + 1 && cell[a] <= p[a] + Rings;
    }
    isNear = isNear || isWithin;
  }
  return isNear;
}

} // namespace

/// Runs are the cells near mixed nodes or on sides, and the nodes of these cells, in HexBox.
TEST(NearCells, AreThoseWithinTheRings)
{
  const IndexBox all{ {}, { { Side, Side, Side } } };
  const IndexBox part{ { { 4, 0, 7 } }, { { 11, Side, 12 } } };
  RandomDraw random(5);
  for (const CartesianGrid& grid : { MakeGrid(all, 0), MakeGrid(part, 4) })
  {
    std::vector<Index> mixed;
    for (int n = 0; n < 5; ++n)
    {
      const Index3 node{ { random.Whole(4, 11), random.Whole(0, 18), random.Whole(7, 12) } };
      mixed.push_back(grid.Linear(node));
    }
    std::sort(mixed.begin(), mixed.end());
    const NearCells near(grid, mixed, Rings);
    const IndexBox box = grid.HexBox(), nodes = NodesOf(box);
    std::vector<int> isCell(box.NumberOfCells(), 0), isNode(nodes.NumberOfCells(), 0);
    ForRows(box,
      [&](Index j, Index k)
      {
        near.ForCells(j, k,
          [&](Index begin, Index end)
          {
            for (Index i = begin; i < end; ++i)
            {
              ++isCell[IndexInBox(box, { { i, j, k } })];
            }
          });
      });
    ForRows(nodes,
      [&](Index j, Index k)
      {
        near.ForNodes(j, k,
          [&](Index begin, Index end)
          {
            for (Index i = begin; i < end; ++i)
            {
              ++isNode[IndexInBox(nodes, { { i, j, k } })];
            }
          });
      });
    std::vector<int> nodesOfCells(nodes.NumberOfCells(), 0);
    ForCells(box,
      [&](const Index3& cell)
      {
        const bool isNear = IsNear(grid, mixed, cell);
        EXPECT_EQ(isCell[IndexInBox(box, cell)], isNear ? 1 : 0) << TextOf(cell);
        for (int c = 0; isNear && c < 8; ++c)
        {
          const Index3 node{ { cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2) } };
          nodesOfCells[IndexInBox(nodes, node)] = 1;
        }
      });
    EXPECT_EQ(isNode, nodesOfCells);
    EXPECT_LT(std::accumulate(isCell.begin(), isCell.end(), Index(0)), box.NumberOfCells());
  }
}
