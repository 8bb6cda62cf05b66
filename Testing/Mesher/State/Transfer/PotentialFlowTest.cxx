/// Flows on graphs of cells.
#include "State/Transfer/PotentialFlow.h"
#include "RandomDraw.h"
#include "State/Transfer/CoarseGraph.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using vfm::testing::RandomDraw;

namespace
{

/// Cells of a box with equal weights between neighbours, on one rank.
/// @param pieceOf  connected component of each cell
FlowGraph MakeGraph(
  const IndexBox& box, double width, const std::function<int(const Index3&)>& pieceOf)
{
  FlowGraph graph;
  for (Index n = 0; n < box.NumberOfCells(); ++n)
  {
    const Index3 p = CellInBox(box, n);
    FlowNode node;
    for (int f = 0; f < 6; ++f)
    {
      Index3 q = p;
      q[f / 2] += f % 2 ? 1 : -1;
      const bool isJoined = box.Contains(q) && pieceOf(q) == pieceOf(p);
      node.Others[f] = static_cast<int>(isJoined ? IndexInBox(box, q) : n);
      node.Widths[f] = isJoined ? width : 0.0;
    }
    graph.Nodes.push_back(node);
    graph.Places.push_back(p);
    graph.Pieces.push_back(pieceOf(p));
  }
  graph.Update = [](std::vector<double>&) {};
  return graph;
}

int OnePiece(const Index3&)
{
  return 1;
}

} // namespace

/// What flows in at one end of a bar flows through every cell.
TEST(PotentialFlow, ThroughABar)
{
  const FlowGraph graph = MakeGraph({ {}, { { 20, 1, 1 } } }, 2.0, OnePiece);
  std::vector<double> excess(20, 0.0);
  excess.front() = 3.0;
  excess.back() = -3.0;
  Runtime runtime;
  const std::vector<double> phi =
    FindPotential(graph, excess, std::vector<double>(20, 1.0), runtime);
  for (int n = 1; n < 20; ++n)
  {
    EXPECT_NEAR(phi[n - 1] - phi[n], 3.0 / 2.0, 1e-8);
  }
}

/// Out of each node flows its excess, in two components that are not connected.
TEST(PotentialFlow, RemovesAnyExcess)
{
  const auto pieceOf = [](const Index3& p) { return p[0] < 5 ? 1 : 2; };
  const FlowGraph graph = MakeGraph({ {}, { { 11, 6, 3 } } }, 0.7, pieceOf);
  RandomDraw random(3);
  std::vector<double> excess(graph.Nodes.size()), sums(3, 0.0);
  for (std::size_t i = 0; i < excess.size(); ++i)
  {
    excess[i] = random.Between(-1, 1);
    sums[graph.Pieces[i]] += excess[i];
  }
  for (int piece : { 1, 2 })
  {
    const auto first = std::find(graph.Pieces.begin(), graph.Pieces.end(), piece);
    excess[first - graph.Pieces.begin()] -= sums[piece];
  }
  Runtime runtime;
  const std::vector<double> phi =
    FindPotential(graph, excess, std::vector<double>(excess.size(), 1.0), runtime);
  for (std::size_t i = 0; i < excess.size(); ++i)
  {
    double outflow = 0.0;
    for (int f = 0; f < 6; ++f)
    {
      outflow += graph.Nodes[i].Widths[f] * (phi[i] - phi[graph.Nodes[i].Others[f]]);
    }
    EXPECT_NEAR(outflow, excess[i], 1e-8);
  }
}

/// A bar of 12 x 2 cells has three blocks of four cells along it, with two edges from block to
/// block.
TEST(CoarseGraph, BlocksOfABar)
{
  const FlowGraph graph = MakeGraph({ {}, { { 12, 2, 1 } } }, 1.5, OnePiece);
  Ranks alone;
  CoarseGraph coarse(graph, alone);
  ASSERT_EQ(coarse.NumberOfBlocks(), 3);
  for (std::size_t i = 0; i < graph.Nodes.size(); ++i)
  {
    EXPECT_EQ(coarse.BlockOf(static_cast<Index>(i)), graph.Places[i][0] / 4);
  }
  Eigen::VectorXd excess(3);
  excess << 6.0 + 1.0, 1.0, -6.0 + 1.0; // the mean, 1, cannot flow anywhere
  const Eigen::VectorXd phi = coarse.Solve(excess);
  EXPECT_NEAR(phi[0] - phi[1], 6.0 / 3.0, 1e-4);
  EXPECT_NEAR(phi[1] - phi[2], 6.0 / 3.0, 1e-4);
  EXPECT_NEAR(phi.sum(), 0.0, 1e-9);
}

TEST(CoarseGraph, ComponentsHaveTheirOwnBlocks)
{
  // The border between the components is inside a block of cells.
  const FlowGraph graph =
    MakeGraph({ {}, { { 8, 1, 1 } } }, 1.0, [](const Index3& p) { return p[0] < 6 ? 1 : 2; });
  Ranks alone;
  CoarseGraph coarse(graph, alone);
  ASSERT_EQ(coarse.NumberOfBlocks(), 3);
  EXPECT_EQ(coarse.BlockOf(5), 1);
  EXPECT_EQ(coarse.BlockOf(6), 2);
  Eigen::VectorXd excess(3);
  excess << 1.0, -1.0, 8.0; // the single block keeps its excess
  const Eigen::VectorXd phi = coarse.Solve(excess);
  EXPECT_NEAR(phi[0] - phi[1], 1.0, 1e-4);
  EXPECT_NEAR(phi[2], 0.0, 1e-12);
}
