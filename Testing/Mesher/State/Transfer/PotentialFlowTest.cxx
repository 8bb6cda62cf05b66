/// Flows on graphs of cells.
#include "State/Transfer/PotentialFlow.h"
#include "RandomDraw.h"
#include "RankFields.h"
#include "State/Transfer/CoarseGraph.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Cells of a box with equal weights between neighbours, of which each rank owns a part.
class BoxGraph
{
public:
  using PieceOf = std::function<int(const Index3&)>;

  /// @param parts  cells of each rank
  /// @param pieceOf  connected component of each cell, from 1
  /// @pre Collective.
  BoxGraph(const IndexBox& box, const std::vector<IndexBox>& parts, double width,
    const PieceOf& pieceOf, Ranks& ranks) :
    Box(box), Part(parts[ranks.Rank()]), Pieces(pieceOf), Group(ranks)
  {
    this->NumberOf.resize(box.NumberOfCells(), -1);
    ForCells(this->Part, [&](const Index3& p) { this->AddCell(p); });
    this->Graph.Nodes.resize(this->Graph.Places.size());
    for (std::size_t i = 0; i < this->Graph.Nodes.size(); ++i)
    {
      this->LinkNode(i, width);
    }
    this->Graph.Copies = static_cast<int>(this->Graph.Places.size() - this->Graph.Nodes.size());
    this->MakeShare(parts);
    for (const Index3& p : this->Graph.Places)
    {
      this->Graph.Pieces.push_back(this->Graph.Components.Find(pieceOf(p)));
    }
    this->Graph.Update = [this](std::vector<double>& values) { this->Update(values); };
  }
  /// A graph on one rank.
  BoxGraph(const IndexBox& box, double width, const PieceOf& pieceOf) :
    BoxGraph(box, { box }, width, pieceOf, Alone)
  {
  }
  BoxGraph(const BoxGraph&) = delete;
  BoxGraph& operator=(const BoxGraph&) = delete;

  FlowGraph Graph;

private:
  void AddCell(const Index3& p)
  {
    int& number = this->NumberOf[IndexInBox(this->Box, p)];
    if (number < 0)
    {
      number = static_cast<int>(this->Graph.Places.size());
      this->Graph.Places.push_back(p);
    }
  }

  void LinkNode(std::size_t i, double width)
  {
    const Index3 p = this->Graph.Places[i];
    for (int f = 0; f < 6; ++f)
    {
      Index3 q = p;
      q[f / 2] += f % 2 ? 1 : -1;
      const bool isJoined = this->Box.Contains(q) && this->Pieces(q) == this->Pieces(p);
      if (isJoined)
      {
        this->AddCell(q); // a copy, if another rank owns it
      }
      FlowNode& node = this->Graph.Nodes[i];
      node.Others[f] = isJoined ? this->NumberOf[IndexInBox(this->Box, q)] : static_cast<int>(i);
      node.Widths[f] = isJoined ? width : 0.0;
    }
  }

  void MakeShare(const std::vector<IndexBox>& parts)
  {
    std::map<int, std::set<int>> ranksOf; // ranks that own cells of a component
    ForCells(this->Box,
      [&](const Index3& p)
      {
        for (int rank = 0; rank < static_cast<int>(parts.size()); ++rank)
        {
          if (parts[rank].Contains(p))
          {
            ranksOf[this->Pieces(p)].insert(rank);
          }
        }
      });
    FragmentShare& share = this->Graph.Components;
    std::vector<Index> shared;
    for (const auto& [piece, owners] : ranksOf)
    {
      if (owners.count(this->Group.Rank()) > 0)
      {
        share.Ids.push_back(piece);
        share.IsMine.push_back(*owners.begin() == this->Group.Rank());
        share.IsShared.push_back(owners.size() > 1);
        if (owners.size() > 1)
        {
          share.Shared.push_back(static_cast<int>(share.Size()) - 1);
          shared.push_back(piece);
        }
      }
    }
    share.Materials.resize(share.Size(), 0);
    share.Ways = KeyMerge<Index>(std::move(shared), this->Group);
    share.Group = &this->Group;
  }

  void Update(std::vector<double>& values)
  {
    struct CellValue
    {
      Index Cell;
      double Value;
    };
    std::vector<CellValue> mine;
    for (std::size_t i = 0; i < this->Graph.Nodes.size(); ++i)
    {
      mine.push_back({ IndexInBox(this->Box, this->Graph.Places[i]), values[i] });
    }
    for (const auto& [cell, value] : GatherItems(this->Group, mine))
    {
      if (this->NumberOf[cell] >= 0)
      {
        values[this->NumberOf[cell]] = value;
      }
    }
  }

  static Ranks Alone;
  const IndexBox Box, Part;
  const PieceOf Pieces;
  Ranks& Group;
  std::vector<int> NumberOf; // node or copy of each cell of the box, or -1
};

Ranks BoxGraph::Alone;

int OnePiece(const Index3&)
{
  return 1;
}

} // namespace

/// What flows in at one end of a bar flows through every cell.
TEST(PotentialFlow, ThroughABar)
{
  const BoxGraph bar({ {}, { { 20, 1, 1 } } }, 2.0, OnePiece);
  std::vector<double> excess(20, 0.0);
  excess.front() = 3.0;
  excess.back() = -3.0;
  Runtime runtime;
  const std::vector<double> phi =
    FindPotential(bar.Graph, excess, std::vector<double>(20, 1.0), runtime);
  for (int n = 1; n < 20; ++n)
  {
    EXPECT_NEAR(phi[n - 1] - phi[n], 3.0 / 2.0, 1e-8);
  }
}

/// Out of each node flows its excess, in two components that are not connected.
TEST(PotentialFlow, RemovesAnyExcess)
{
  const auto pieceOf = [](const Index3& p) { return p[0] < 5 ? 1 : 2; };
  const BoxGraph made({ {}, { { 11, 6, 3 } } }, 0.7, pieceOf);
  const FlowGraph& graph = made.Graph;
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
  const BoxGraph bar({ {}, { { 12, 2, 1 } } }, 1.5, OnePiece);
  Ranks alone;
  const CoarseGraph coarse(bar.Graph, alone);
  ASSERT_EQ(coarse.NumberOfBlocks(), 3);
  for (std::size_t i = 0; i < bar.Graph.Nodes.size(); ++i)
  {
    EXPECT_EQ(coarse.BlockOf(static_cast<Index>(i)), bar.Graph.Places[i][0] / 4);
  }
  // in units of 1/2; the mean, 1, cannot flow anywhere
  const std::vector<double> phi = coarse.Solve({ 12 + 2, 2, -12 + 2 }, 0.5);
  EXPECT_NEAR(phi[0] - phi[1], 6.0 / 3.0, 1e-4);
  EXPECT_NEAR(phi[1] - phi[2], 6.0 / 3.0, 1e-4);
  EXPECT_NEAR(phi[0] + phi[1] + phi[2], 0.0, 1e-9);
}

TEST(CoarseGraph, ComponentsHaveTheirOwnBlocks)
{
  // The border between the components is inside a block of cells.
  const BoxGraph made(
    { {}, { { 8, 1, 1 } } }, 1.0, [](const Index3& p) { return p[0] < 6 ? 1 : 2; });
  Ranks alone;
  const CoarseGraph coarse(made.Graph, alone);
  ASSERT_EQ(coarse.NumberOfBlocks(), 3);
  EXPECT_EQ(coarse.BlockOf(5), 1);
  EXPECT_EQ(coarse.BlockOf(6), 2);
  const std::vector<double> phi = coarse.Solve({ 1, -1, 8 }, 1.0);
  EXPECT_NEAR(phi[0] - phi[1], 1.0, 1e-4);
  EXPECT_EQ(phi[2], 0.0); // a single block keeps its excess
}

/// More components than the limit of blocks of one component do not make its blocks larger.
TEST(CoarseGraph, ManyComponentsKeepSmallBlocks)
{
  const IndexBox box{ {}, { { 8, 5000, 1 } } };
  const BoxGraph bars(box, 1.0, [](const Index3& p) { return 1 + static_cast<int>(p[1]); });
  Ranks alone;
  EXPECT_EQ(CoarseGraph(bars.Graph, alone).NumberOfBlocks(), 2 * 5000);
  // One component of 20,000 blocks of 4 cells gets wider ones.
  const BoxGraph one({ {}, { { 80000, 1, 1 } } }, 1.0, OnePiece);
  EXPECT_EQ(CoarseGraph(one.Graph, alone).NumberOfBlocks(), 80000 / 32);
}

/// Potentials are bitwise identical on any number of ranks, and nothing is gathered.
TEST(CoarseGraph, RanksChangeNothing)
{
  const IndexBox box{ {}, { { 24, 13, 9 } } };
  const auto pieceOf = [](const Index3& p) {
    return p[0] < 9 ? 1 : p[1] < 4 ? 2 + static_cast<int>(p[0]) / 5 : 20;
  };
  std::map<std::array<Index, 3>, double> expected;
  for (int count : { 1, 2, 3, 5, 8, 27 })
  {
    const std::vector<IndexBox> parts = CutBox(box, count, -1);
    std::vector<std::map<std::array<Index, 3>, double>> found(count);
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        const BoxGraph made(box, parts, 0.7, pieceOf, ranks);
        const std::int64_t before = ranks.Sent().GatheredBytes;
        const CoarseGraph coarse(made.Graph, ranks);
        std::vector<std::int64_t> excess(coarse.NumberOfBlocks(), 0);
        const std::size_t nodes = made.Graph.Nodes.size();
        for (std::size_t i = 0; i < nodes; ++i)
        {
          excess[coarse.BlockOf(static_cast<Index>(i))] +=
            IndexInBox(box, made.Graph.Places[i]) % 17;
        }
        const std::vector<double> phi = coarse.Solve(excess, 0.25);
        EXPECT_EQ(ranks.Sent().GatheredBytes, before);
        for (std::size_t i = 0; i < nodes; ++i)
        {
          found[ranks.Rank()][made.Graph.Places[i]] = phi[coarse.BlockOf(static_cast<Index>(i))];
        }
      });
    std::map<std::array<Index, 3>, double> all;
    for (const auto& part : found)
    {
      all.insert(part.begin(), part.end());
    }
    expected = count == 1 ? all : expected;
    EXPECT_EQ(static_cast<Index>(all.size()), box.NumberOfCells());
    EXPECT_TRUE(all == expected) << count << " ranks";
  }
}
