/**
 * Neighbours move in the order of their colours in any order of nodes, and never in two tasks of
 * the same step.
 */
#include "Smoothing/MoveOrder.h"
#include "Smoothing/ActiveMeshBuilder.h"

#include "MeshCases.h"
#include "RankFields.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <mutex>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Position of a node in an order.
struct Place
{
  std::size_t Step = 0;
  Index Task = 0, At = 0;
};

/// Returns the place of each node; node n has the points { n, n + 1 }.
std::vector<Place> FindPlaces(const MoveOrder& order, std::size_t nodes)
{
  std::vector<Place> places(nodes);
  std::vector<int> count(nodes, 0);
  for (std::size_t s = 0; s < order.Steps().size(); ++s)
  {
    const std::vector<Index>& tasks = order.Steps()[s].Tasks;
    for (std::size_t t = 0; t + 1 < tasks.size(); ++t)
    {
      for (Index g = tasks[t]; g < tasks[t + 1]; ++g)
      {
        const std::size_t node = order.Groups()[g].First;
        places[node] = { s, static_cast<Index>(t), g };
        ++count[node];
      }
    }
  }
  EXPECT_EQ(count, std::vector<int>(nodes, 1));
  return places;
}

bool AreNeighbours(const Index3& a, const Index3& b)
{
  return std::abs(a[0] - b[0]) <= 1 && std::abs(a[1] - b[1]) <= 1 && std::abs(a[2] - b[2]) <= 1;
}

/// Counts pairs of neighbours that do not keep their order or may move at the same time.
int CountWrong(const std::vector<MoveOrder::Node>& nodes, const MoveOrder& order)
{
  const std::vector<Place> places = FindPlaces(order, nodes.size());
  int wrong = 0;
  for (std::size_t a = 0; a < nodes.size(); ++a)
  {
    for (std::size_t b = 0; b < nodes.size(); ++b)
    {
      if (nodes[a].Colour < nodes[b].Colour && AreNeighbours(nodes[a].At, nodes[b].At))
      {
        const Place &first = places[a], &second = places[b];
        wrong += first.Step > second.Step || (first.Step == second.Step && first.At > second.At) ||
          (first.Step == second.Step && first.Task != second.Task);
      }
    }
  }
  return wrong;
}

/// Returns a random subset of the nodes of a box.
std::vector<MoveOrder::Node> MakeNodes(const Index3& size, double share, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<MoveOrder::Node> nodes;
  ForCells({ { { 0, 0, 0 } }, size },
    [&](const Index3& p)
    {
      if (random() < share * 4294967296.0)
      {
        const int n = static_cast<int>(nodes.size());
        nodes.push_back({ p, CartesianGrid::Parities(p), { n, n + 1 } });
      }
    });
  return nodes;
}

std::size_t LargestStep(const MoveOrder& order)
{
  std::size_t tasks = 0;
  for (const MoveOrder::Step& step : order.Steps())
  {
    tasks = std::max(tasks, step.Tasks.size() - 1);
  }
  return tasks;
}

} // namespace

TEST(MoveOrder, KeepsTheOrderOfNeighbours)
{
  for (const Index3& size : { Index3{ { 9, 8, 20 } }, Index3{ { 40, 30, 2 } },
         Index3{ { 60, 3, 2 } }, Index3{ { 1, 1, 1 } }, Index3{ { 13, 14, 15 } } })
  {
    for (const double share : { 0.3, 1.0 })
    {
      SCOPED_TRACE(std::to_string(size[0]) + " " + std::to_string(share));
      const std::vector<MoveOrder::Node> nodes = MakeNodes(size, share, 7);
      EXPECT_EQ(CountWrong(nodes, MoveOrder::ByColour(nodes, 8)), 0);
      EXPECT_EQ(CountWrong(nodes, MoveOrder::ByPlanes(nodes, PointExchange())), 0);
    }
  }
}

TEST(MoveOrder, VisitsFlaggedPointsInTheOrderOfAll)
{
  const std::vector<MoveOrder::Node> nodes = MakeNodes({ { 40, 9, 5 } }, 0.8, 3);
  const MoveOrder order = MoveOrder::ByPlanes(nodes, PointExchange());
  const Index groups = static_cast<Index>(order.Groups().size());
  const auto visit = [&](Index first, Index last, const std::vector<unsigned char>& flags)
  {
    std::vector<int> points;
    order.ForPoints(first, last, flags.empty() ? nullptr : flags.data(),
      [&](int point) { points.push_back(point); });
    return points;
  };
  std::mt19937 random(4);
  for (const double share : { 0.0, 0.001, 0.03, 0.5, 1.0 })
  {
    std::vector<unsigned char> flags(nodes.size());
    std::generate(flags.begin(), flags.end(), [&] { return random() <= share * 4294967295.0; });
    for (const auto& [first, last] : { std::pair<Index, Index>{ 0, groups }, { 5, 6 }, { 31, 97 },
           { 64, groups - 1 }, { 40, 40 } })
    {
      const std::vector<int> all = visit(first, last, {});
      std::vector<int> right;
      for (Index g = first; g < last; ++g)
      {
        EXPECT_EQ(all[g - first], order.Groups()[g].First);
      }
      std::copy_if(all.begin(), all.end(), std::back_inserter(right),
        [&](int point) { return flags[point] != 0; });
      EXPECT_EQ(visit(first, last, flags), right) << share << " " << first;
    }
  }
}

TEST(MoveOrder, GivesThreadsTasksInFlatMeshes)
{
  const PointExchange alone;
  const MoveOrder cube = MoveOrder::ByPlanes(MakeNodes({ { 20, 20, 20 } }, 1.0, 1), alone);
  EXPECT_EQ(cube.Steps().size(), 2u);
  EXPECT_GE(LargestStep(cube), 8u);
  const MoveOrder flat = MoveOrder::ByPlanes(MakeNodes({ { 50, 40, 3 } }, 1.0, 1), alone);
  EXPECT_EQ(flat.Steps().size(), 4u);
  EXPECT_GE(LargestStep(flat), 8u);
  const MoveOrder thin = MoveOrder::ByPlanes(MakeNodes({ { 300, 3, 3 } }, 1.0, 1), alone);
  EXPECT_EQ(thin.Steps().size(), 8u);
  EXPECT_GE(LargestStep(thin), 8u);
}

TEST(MoveOrder, PutsWhatOtherRanksShareFirst)
{
  const CartesianGrid whole = MakeUnitGrid(16);
  for (const int axis : { 0, 1, 2 })
  {
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), 2, axis);
    std::mutex lock;
    RunOnRanks(2,
      [&](Ranks& ranks)
      {
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        const Partition partition(grid, ranks);
        std::vector<Mover> movers;
        std::vector<MoveOrder::Node> nodes;
        ForCells(NodesOf(grid.HexBox()),
          [&](const Index3& p)
          {
            const int n = static_cast<int>(movers.size()), colour = CartesianGrid::Parities(p);
            movers.push_back({ n, grid.NodeKey(p), grid.NodeKey(p), p, colour });
          });
        std::vector<int> placeOf(movers.size(), -1);
        for (std::size_t m = 0; m < movers.size(); ++m)
        {
          if (partition.OwnsNode(movers[m].Owner))
          {
            const int n = static_cast<int>(m);
            nodes.push_back({ movers[m].Owner, movers[m].Colour, { n, n + 1 } });
          }
        }
        const MoverCopies noCopies{ [](Index id, const Index3&) { return id; },
          { { 1.0, 1.0, 1.0 } } };
        const PointExchange exchange(movers, partition, 8, noCopies);
        MoveOrder order = MoveOrder::ByPlanes(nodes, exchange);
        std::vector<int> step(movers.size(), -1);
        for (std::size_t s = 0; s < order.Steps().size(); ++s)
        {
          for (Index g = order.Steps()[s].Tasks.front(); g < order.Steps()[s].Tasks.back(); ++g)
          {
            step[order.Groups()[g].First] = static_cast<int>(s);
          }
        }
        const std::lock_guard<std::mutex> guard(lock);
        exchange.ForSent([&](int mover) { EXPECT_EQ(step[mover], movers[mover].Colour); });
        int inside = 0;
        for (const MoveOrder::Node& node : nodes)
        {
          inside += step[node.Points.First] >= 8;
          for (const MoveOrder::Node& other : nodes)
          {
            if (node.Colour < other.Colour && AreNeighbours(node.At, other.At))
            {
              EXPECT_LE(step[node.Points.First], step[other.Points.First]);
            }
          }
        }
        EXPECT_GT(inside, static_cast<int>(nodes.size()) / 4);
      });
  }
}
