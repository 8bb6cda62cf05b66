/// Copies of points on ranks and across the seams of a periodic domain.
#include "Elements/PointExchange.h"
#include "CellMesh.h"
#include "Elements/PeriodicIds.h"
#include "Elements/PointValues.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// 4 x 3 x 4 cells, periodic along x and z. Lengths are powers of two there.
CartesianGrid MakeRepeatedGrid(const IndexBox& owned)
{
  const std::vector<double> x{ 0.0, 1.0, 1.5, 3.0, 4.0 };
  return CartesianGrid::Covering(
    { { x, { 0.0, 1.0, 2.5, 3.0 }, x } }, owned, { { true, false, true } }, Seam::Free, 3);
}

/// Calls body(ranks, grid, partition, mesh) on ranks that each own a slab of the cells.
void ForSlabs(int count,
  const std::function<void(Ranks&, const CartesianGrid&, const Partition&, const Mesh&)>& body)
{
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const Index first = 4 * ranks.Rank() / count, last = 4 * (ranks.Rank() + 1) / count;
      const CartesianGrid grid = MakeRepeatedGrid({ { { first, 0, 0 } }, { { last, 3, 4 } } });
      const Partition partition(grid, ranks);
      const Mesh mesh = MakeCellMesh(grid, ranks, [](const Index3&) { return 1; });
      body(ranks, grid, partition, mesh);
    });
}

Index3 NodeAt(const CartesianGrid& grid, const Mesh& mesh, std::size_t point)
{
  return NodeOfPoint(grid, mesh, mesh.PointIds[point]);
}

/// Returns the node between the upper ends of the domain along x and z that is a copy of a node.
Index3 OwnedCopy(const CartesianGrid& grid, Index3 node)
{
  for (int a : { 0, 2 })
  {
    const Index first = grid.Domain().Lower[a] + 1;
    node[a] = first + ((node[a] - first) % 4 + 4) % 4;
  }
  return node;
}

std::vector<Mover> ListMovers(const CartesianGrid& grid, const Mesh& mesh)
{
  std::vector<Mover> movers;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    const Index3 node = NodeAt(grid, mesh, p);
    movers.push_back(
      { static_cast<Index>(p), mesh.PointIds[p], grid.NodeKey(node), node, grid.Colour(node) });
  }
  return movers;
}

} // namespace

TEST(PeriodicIds, OwnersAreWholePeriodsAway)
{
  ForSlabs(1,
    [](Ranks&, const CartesianGrid& grid, const Partition& partition, const Mesh& mesh)
    {
      const IndexBox& domain = grid.Domain();
      for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
      {
        const Index3 node = NodeAt(grid, mesh, p);
        const auto isBeyond = [&](int a)
        { return node[a] <= domain.Lower[a] || node[a] >= domain.Upper[a]; };
        EXPECT_EQ(HasCopies(grid, node), isBeyond(0) || isBeyond(2));
        const Index id = grid.NodeKey(node) * 16 + 4; // slot 3
        EXPECT_EQ(IdOfOwner(mesh, id), grid.NodeKey(OwnedCopy(grid, node)) * 16 + 4);
        for (std::size_t peer = 0; peer < partition.Peers().size(); ++peer)
        {
          const Index3 shift = partition.ShiftOf(peer);
          const Index3 there{ { node[0] - shift[0], node[1], node[2] - shift[2] } };
          EXPECT_EQ(IdAtPeer(mesh, partition, peer, id), grid.NodeKey(there) * 16 + 4);
        }
      }
    });
}

TEST(PeriodicIds, CellsCountOnTheirLevel)
{
  const OctreeKeys::LevelIndex node{ 2, { { 20, 16, 8 } }, 5 };
  const Index3 cells{ { 2, 1, 0 } };
  // A cell of level 0 is four of level 2; level 3 has half of the widths.
  EXPECT_EQ(Below(node, cells, 0).At, (Index3{ { 12, 12, 8 } }));
  EXPECT_EQ(Below(node, cells, 2).At, (Index3{ { 18, 15, 8 } }));
  EXPECT_EQ(Below(node, { { 2, 6, 0 } }, 3).At, (Index3{ { 19, 13, 8 } }));
  EXPECT_EQ(Below(node, cells, 0).Slot, 5);
  ForSlabs(1,
    [](Ranks&, const CartesianGrid& grid, const Partition&, const Mesh& mesh)
    {
      const Index id = grid.NodeKey({ { 7, 2, 6 } }) * 16 + 2;
      EXPECT_EQ(CopiesOfMovers(mesh, 1).IdBelow(id, { { 2, 0, 1 } }),
        grid.NodeKey({ { 3, 2, 4 } }) * 16 + 2);
      EXPECT_NEAR(CopiesOfMovers(mesh).Unit[1], std::cbrt(1.0), 1e-15);
      const OctreeKeys lattice(grid, 1);
      const Index key = lattice.NodeKey(1, { { 9, 4, 12 } }, 13);
      EXPECT_EQ(CopiesOfAnchors(lattice, {}).IdBelow(key, { { 4, 0, 0 } }),
        lattice.NodeKey(1, { { 1, 4, 12 } }, 13));
    });
}

TEST(PointValues, AreThoseOfOwners)
{
  for (int count : { 1, 2 })
  {
    ForSlabs(count,
      [](Ranks&, const CartesianGrid& grid, const Partition& partition, const Mesh& mesh)
      {
        std::vector<Index> points, ids;
        for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
        {
          points.push_back(static_cast<Index>(p));
          ids.push_back(partition.OwnsNode(NodeAt(grid, mesh, p)) ? mesh.PointIds[p] : -1);
        }
        std::vector<int> calls(points.size(), 0);
        PointValues(points, mesh, partition)
          .Fetch(ids,
            [&](Index point, Index id)
            {
              ++calls[point];
              EXPECT_EQ(id, grid.NodeKey(OwnedCopy(grid, NodeAt(grid, mesh, point))) * 16 + 1);
            });
        for (std::size_t p = 0; p < calls.size(); ++p)
        {
          EXPECT_EQ(calls[p], ids[p] < 0 ? 1 : 0);
        }
      });
  }
}

TEST(PointExchange, GhostsGetTranslatedPositionsAndFlags)
{
  for (int count : { 1, 2 })
  {
    ForSlabs(count,
      [](Ranks&, const CartesianGrid& grid, const Partition& partition, const Mesh& mesh)
      {
        const std::vector<Mover> movers = ListMovers(grid, mesh);
        const double unit = grid.MeanWidth();
        PointExchange exchange(movers, partition, grid.NumberOfColours(), CopiesOfMovers(mesh));
        ASSERT_TRUE(exchange.HasPeers());
        std::vector<Vector3> points;
        std::vector<unsigned char> flags, requested;
        std::vector<int> received(movers.size(), 0);
        const auto isFlagged = [&](const Index3& node)
        { return OwnedCopy(grid, node)[0] % 2 == 0; };
        for (const Mover& mover : movers)
        {
          const Vector3 x = mesh.PointAt(mover.MeshPoint);
          const bool isOwned = partition.OwnsNode(mover.Owner);
          const double moved = isOwned ? 1.0 : 0.0;
          points.push_back({ { x[0] / unit + moved, x[1] / unit, x[2] / unit - moved } });
          flags.push_back(isOwned && isFlagged(mover.Owner));
          requested.push_back(mover.Owner[1] > 0);
        }
        exchange.RequestFlags(requested);
        for (int colour = 0; colour < exchange.CountColours(); ++colour)
        {
          exchange.Send(colour, points, flags,
            [&](int mover)
            {
              ++received[mover];
              EXPECT_EQ(movers[mover].Colour, colour);
            });
        }
        for (std::size_t m = 0; m < movers.size(); ++m)
        {
          const Vector3 x = mesh.PointAt(movers[m].MeshPoint);
          EXPECT_NEAR(points[m][0], x[0] / unit + 1.0, 1e-12);
          EXPECT_NEAR(points[m][1], x[1] / unit, 1e-12);
          EXPECT_NEAR(points[m][2], x[2] / unit - 1.0, 1e-12);
          const Index3& node = movers[m].Owner;
          EXPECT_EQ(received[m], !partition.OwnsNode(node) && isFlagged(node) && node[1] > 0);
        }
      });
  }
}

/// What owners send to their ghosts comes back once per ghost.
TEST(PointExchange, GhostsReturnValues)
{
  ForSlabs(2,
    [](Ranks& ranks, const CartesianGrid& grid, const Partition& partition, const Mesh& mesh)
    {
      const std::vector<Mover> movers = ListMovers(grid, mesh);
      const PointExchange exchange(movers, partition, grid.NumberOfColours(), CopiesOfMovers(mesh));
      std::vector<Index> owner(movers.size(), 0);
      exchange.SendAll([&](int mover) { return movers[mover].Id; },
        [&](int mover, Index id) { owner[mover] = id; });
      std::vector<int> sent(movers.size(), 0), returned(movers.size(), 0);
      exchange.ForSent([&](int mover) { ++sent[mover]; });
      exchange.ReturnAll([&](int mover) { return owner[mover]; },
        [&](int mover, Index id)
        {
          ++returned[mover];
          EXPECT_EQ(id, movers[mover].Id);
        });
      EXPECT_EQ(sent, returned);
      std::vector<std::int64_t> counts(2, 0);
      for (std::size_t m = 0; m < movers.size(); ++m)
      {
        counts[0] += returned[m];
        counts[1] += !partition.OwnsNode(movers[m].Owner);
      }
      ranks.Sum(counts);
      EXPECT_GT(counts[1], 100);
      EXPECT_EQ(counts[0], counts[1]);
    });
}
