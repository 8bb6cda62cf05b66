/// Peers of ranks with any boxes, against all pairs of ranks.
#include "Base/Partition.h"
#include "RandomDraw.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// A domain and the boxes of all ranks.
struct Division
{
  IndexBox Domain;
  std::vector<IndexBox> Boxes;
  std::array<bool, 3> IsPeriodic;
  int GhostLayers;
};

/// Cuts a box at random places into boxes for some ranks; some get none.
void Cut(const IndexBox& box, int first, int count, RandomDraw& draw, std::vector<IndexBox>& boxes)
{
  if (count == 1)
  {
    boxes[first] = box;
    return;
  }
  const int axis = draw.Whole(0, 2), low = draw.Whole(1, count - 1);
  IndexBox lower = box, upper = box;
  lower.Upper[axis] = upper.Lower[axis] =
    box.Lower[axis] + draw.Whole(0, static_cast<int>(box.Size(axis)));
  Cut(lower, first, low, draw, boxes);
  Cut(upper, first + low, count - low, draw, boxes);
}

Division DrawDivision(int count, unsigned seed)
{
  RandomDraw draw(seed);
  Division division;
  for (int a = 0; a < 3; ++a)
  {
    division.Domain.Upper[a] = draw.Whole(2, 40);
    division.IsPeriodic[a] = draw.Chance(0.5);
  }
  division.GhostLayers = draw.Whole(1, 6);
  division.Boxes.resize(count);
  Cut(division.Domain, 0, count, draw, division.Boxes);
  for (int rank = count - 1; rank > 0; --rank)
  {
    std::swap(division.Boxes[rank], division.Boxes[draw.Whole(0, rank)]);
  }
  return division;
}

/// One box of half of a long domain, and small ones.
Division OneHugeBox(int count)
{
  Division division{ { {}, { { 4 * count, 8, 8 } } }, std::vector<IndexBox>(count),
    { { true, false, false } }, 3 };
  for (int rank = 0; rank < count; ++rank)
  {
    IndexBox box = division.Domain;
    box.Lower[0] = rank == 0 ? 2 * count : 2 * (rank - 1);
    box.Upper[0] = rank == 0 ? 4 * count : 2 * (rank - 1) + (rank == count - 1 ? 4 : 2);
    division.Boxes[rank] = box;
  }
  return division;
}

CartesianGrid GridOf(const Division& division, int rank)
{
  std::array<std::vector<double>, 3> nodes;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= division.Domain.Upper[a]; ++i)
    {
      nodes[a].push_back(static_cast<double>(i));
    }
  }
  return CartesianGrid::Covering(
    nodes, division.Boxes[rank], division.IsPeriodic, Seam::Free, division.GhostLayers);
}

/// Rank and shift in cells.
using Peer = std::pair<int, Index3>;

/// Returns the peers of a rank from the grids of all ranks.
std::vector<Peer> ListPeers(const std::vector<CartesianGrid>& grids, int rank)
{
  std::vector<Peer> peers;
  const CartesianGrid& own = grids[rank];
  for (int other = 0; other < static_cast<int>(grids.size()); ++other)
  {
    ForCells({ { { -7, -7, -7 } }, { { 8, 8, 8 } } }, // in the order of shifts; more than possible
      [&](const Index3& shift)
      {
        for (int a = 0; a < 3; ++a)
        {
          if (own.Period(a) == 0 && shift[a] != 0)
          {
            return;
          }
        }
        const Index3 up = own.CellsInPeriods(shift), down{ { -up[0], -up[1], -up[2] } };
        const bool receives =
          Intersect(own.Local(), Moved(grids[other].Owned(), up)).NumberOfCells() > 0;
        const bool sends =
          Intersect(own.Owned(), Moved(grids[other].Local(), down)).NumberOfCells() > 0;
        if ((other != rank || shift != Index3{}) && (receives || sends))
        {
          peers.emplace_back(other, up);
        }
      });
  }
  return peers;
}

/// Checks the peers of all ranks, and the values that they exchange.
void CheckDivision(const Division& division)
{
  const int count = static_cast<int>(division.Boxes.size());
  std::vector<CartesianGrid> grids;
  for (int rank = 0; rank < count; ++rank)
  {
    grids.push_back(GridOf(division, rank));
  }
  RunOnRanks(count,
    [&](ThreadRanks& ranks)
    {
      const CartesianGrid& grid = grids[ranks.Rank()];
      const Partition partition(grid, ranks);
      EXPECT_EQ(ranks.Sent().GatheredBytes, 0);
      std::vector<Peer> found;
      for (std::size_t peer = 0; peer < partition.Peers().size(); ++peer)
      {
        found.emplace_back(partition.Peers()[peer], partition.ShiftOf(peer));
      }
      EXPECT_EQ(found, ListPeers(grids, ranks.Rank()));
      std::vector<Index> keys(grid.NumberOfEntries(), -1);
      ForCells(
        grid.Owned(), [&](const Index3& cell) { keys[grid.Linear(cell)] = grid.CellKey(cell); });
      partition.ExchangeCells(keys.data());
      ForCells(grid.Local(),
        [&](const Index3& cell)
        { EXPECT_EQ(keys[grid.Linear(cell)], grid.CellKey(grid.Canonical(cell))); });
    });
}

} // namespace

TEST(Partition, PeersOfRandomBoxes)
{
  for (int count : { 1, 2, 3, 5, 8, 13, 27, 64 })
  {
    for (unsigned seed = 0; seed < (count > 20 ? 3u : 12u); ++seed)
    {
      SCOPED_TRACE(std::to_string(count) + " ranks, seed " + std::to_string(seed));
      CheckDivision(DrawDivision(count, 100 * count + seed));
    }
  }
}

TEST(Partition, OneHugeBoxAndManySmall)
{
  for (int count : { 2, 9, 40 })
  {
    CheckDivision(OneHugeBox(count));
  }
}
