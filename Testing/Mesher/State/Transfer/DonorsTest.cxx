/// Donors in cells, their copies on other ranks, and the graph between which contents move.
#include "State/Transfer/Donors.h"
#include "CellMesh.h"
#include "MeshChecks.h"
#include "RankFields.h"
#include "State/Transfer/FlowNodes.h"
#include "State/Transfer/MismatchCells.h"

#include <gtest/gtest.h>

#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Cells of material 1, all whole elements except for some mixed cells, on ranks that each own a
/// slab. Every cell has a donor of fragment 1.
struct MixedCells
{
  MixedCells(Ranks& ranks, const CartesianGrid& grid, const std::vector<Index3>& mixed) :
    Run(ranks),
    Grid(grid),
    Parts(grid, ranks),
    Cells(MakeCellMesh(
      CartesianGrid(grid, grid.Owned(), 0, 0), ranks, [](const Index3&) { return 1; })),
    Fractions(MakeFractions(grid, mixed)),
    Whole(this->Cells, grid, this->Fractions, this->Run),
    Donors(grid)
  {
    ForCells(grid.Owned(),
      [this](const Index3& p)
      {
        const int donor = this->Donors.Get(this->Grid.Linear(p), 1, 1);
        this->Donors[donor].Overlap = this->Donors[donor].Volume = 1.0;
      });
  }

  static FractionField MakeFractions(const CartesianGrid& grid, const std::vector<Index3>& mixed)
  {
    FractionField fractions = MakeLabels(grid, 1, [](const Index3&) { return 1; });
    for (const Index3& cell : mixed)
    {
      if (grid.Local().Contains(cell))
      {
        fractions.SetParts(grid.Linear(cell), { { 1, 0.5 } });
      }
    }
    return fractions;
  }

  RankRuntime Run;
  const CartesianGrid& Grid;
  const Partition Parts;
  const Mesh Cells;
  const FractionField Fractions;
  const WholeElements Whole;
  DonorTable Donors;
  const MismatchCells Mismatches{ Grid, Fractions, Whole, Donors, { 0, 1 }, Parts };
};

Index Distance(const Index3& a, const Index3& b)
{
  return std::max({ std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) });
}

void ForMixedCells(const std::vector<Index3>& mixed, const std::function<void(MixedCells&)>& body)
{
  const CartesianGrid whole = MakeUnitGrid(16, 5, 5);
  for (int count : { 1, 2 })
  {
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), count, 0);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()], { GhostLayers, 0 });
        MixedCells cells(ranks, grid, mixed);
        body(cells);
      });
  }
}

} // namespace

TEST(Donors, OfACellAreInTheOrderOfFragments)
{
  const CartesianGrid grid = MakeUnevenGrid(3);
  DonorTable donors(grid);
  const Index cell = grid.Linear({ { 1, 1, 2 } });
  const int b = donors.Get(cell, 5, 2), c = donors.Get(cell, 9, 3), a = donors.Get(cell, 2, 2);
  const int next = donors.Get(cell + 1, 5, 2);
  EXPECT_EQ(donors.Get(cell, 9, 3), c);
  EXPECT_EQ(donors.Count(), 4);
  std::vector<int> order;
  donors.ForCell(cell, [&](int donor) { order.push_back(donor); });
  EXPECT_EQ(order, (std::vector<int>{ a, b, c }));
  EXPECT_EQ(donors.Find(cell, 5), b);
  EXPECT_EQ(donors.Find(cell, 3), -1);
  EXPECT_EQ(donors.FindThree(cell, 5), (std::array<int, 3>{ { -1, b, next } }));
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& x = grid.Coordinates(axis);
    const Index i = axis == 2 ? 2 : 1;
    EXPECT_DOUBLE_EQ(donors[a].Centroid[axis], 0.5 * (x[i] + x[i + 1]));
  }
  EXPECT_TRUE(donors[a].IsOwned);
}

/// Copies get the overlaps and numbers of their owners, also across a seam.
TEST(Donors, CopiesFollowTheirOwners)
{
  const std::vector<double> x{ 0, 1, 2, 3, 4, 5, 6, 7, 8 };
  RunOnRanks(2,
    [&](Ranks& ranks)
    {
      const Index first = 4 * ranks.Rank();
      const CartesianGrid grid = CartesianGrid::Covering({ { x, { 0, 1 }, { 0, 1 } } },
        { { { first, 0, 0 } }, { { first + 4, 1, 1 } } }, { { true, false, false } }, Seam::Free,
        2);
      const Partition partition(grid, ranks);
      DonorTable donors(grid);
      ForCells(grid.Owned(),
        [&](const Index3& p)
        {
          const int donor = donors.Get(grid.Linear(p), 1, 1);
          donors[donor].Overlap = static_cast<double>(p[0]);
          donors[donor].Centroid[1] = 0.75;
        });
      const DonorLinks links(grid, partition, donors);
      ASSERT_EQ(donors.Count(), 4 + 2 + 2);
      int copies = 0;
      links.ForCopies(
        [&](int s)
        {
          ++copies;
          const Index3 p = grid.Position(donors[s].Cell);
          EXPECT_FALSE(donors[s].IsOwned);
          EXPECT_EQ(donors[s].Overlap, static_cast<double>(grid.Canonical(p)[0]));
          EXPECT_EQ(donors[s].Centroid[0], grid.NodePoint(p)[0] + 0.5);
          EXPECT_EQ(donors[s].Centroid[1], 0.75);
        });
      EXPECT_EQ(copies, 4);
      std::set<int> received;
      const auto isLow = [&](int s) { return donors[s].Cell < grid.Linear(grid.Owned().Lower); };
      links.Narrow(isLow).Exchange(
        2,
        [&](int s, double* numbers)
        {
          EXPECT_TRUE(donors[s].IsOwned);
          numbers[0] = donors[s].Overlap;
          numbers[1] = -1.0;
        },
        [&](int s, const double* numbers)
        {
          EXPECT_TRUE(isLow(s));
          EXPECT_EQ(numbers[0], donors[s].Overlap);
          EXPECT_EQ(numbers[1], -1.0);
          received.insert(s);
        });
      EXPECT_EQ(received.size(), 2u);
    });
}

TEST(MismatchCells, AreMixedCellsAndTheirSurroundings)
{
  const Index3 mixed{ { 9, 2, 2 } };
  ForMixedCells({ mixed },
    [&mixed](MixedCells& c)
    {
      ForCells(c.Grid.Owned(),
        [&](const Index3& p)
        {
          for (int layers = 0; layers <= DonorLayers; ++layers)
          {
            EXPECT_EQ(c.Mismatches.IsNear(c.Grid.Linear(p), layers), Distance(p, mixed) <= layers);
          }
        });
    });
}

/// A pure cell without a whole element is a mismatch unless donors of its material fill it.
TEST(MismatchCells, DonorsMustFillTheirCell)
{
  const CartesianGrid grid = MakeUnitGrid(3, 1, 1);
  Runtime runtime;
  const Partition partition(grid, runtime.Group());
  const FractionField fractions = MakeLabels(grid, 2, [](const Index3&) { return 1; });
  Mesh none;
  none.ResizeElements(0);
  const WholeElements whole(none, grid, fractions, runtime);
  const auto isMismatch = [&](int material, double overlap)
  {
    DonorTable donors(grid);
    ForCells(grid.Global(),
      [&](const Index3& p) { donors[donors.Get(grid.Linear(p), 1, 1)].Overlap = 1.0; });
    const Index cell = grid.Linear({ { 1, 0, 0 } });
    donors[donors.Get(cell, material, material)].Overlap = overlap;
    return MismatchCells(grid, fractions, whole, donors, { 0, 1, 1 }, partition).IsNear(cell, 0);
  };
  EXPECT_FALSE(isMismatch(1, 1.0 + 1e-13));
  EXPECT_TRUE(isMismatch(1, 1.0 - 1e-9));
  EXPECT_TRUE(isMismatch(1, 1.0 + 1e-9));
  EXPECT_TRUE(isMismatch(2, 1e-9));
  EXPECT_FALSE(isMismatch(2, 0.0));
}

/// Returns the fragments of all connected components, which a rank has its numbers of.
/// @pre Collective.
std::vector<int> ListFragments(const FlowGraph& graph)
{
  const FragmentShare& components = graph.Components;
  std::vector<std::array<int, 2>> mine; // number over all ranks, fragment
  for (std::size_t p = 1; p < components.Size(); ++p)
  {
    if (components.IsMine[p])
    {
      mine.push_back({ { components.Ids[p], components.Materials[p] } });
    }
  }
  mine = GatherItems(*components.Group, mine);
  std::sort(mine.begin(), mine.end());
  EXPECT_EQ(static_cast<Index>(mine.size()), components.Total);
  std::vector<int> fragments;
  for (std::size_t p = 0; p < mine.size(); ++p)
  {
    EXPECT_EQ(mine[p][0], static_cast<int>(p) + 1);
    fragments.push_back(mine[p][1]);
  }
  return fragments;
}

TEST(FlowNodes, AreDonorsNearMismatchCells)
{
  const Index3 mixed{ { 8, 2, 2 } };
  ForMixedCells({ mixed },
    [&mixed](MixedCells& c)
    {
      const DonorLinks links(c.Grid, c.Parts, c.Donors);
      EXPECT_TRUE(FindDivided(c.Grid, c.Mismatches, links, c.Donors, c.Parts.Group()).empty());
      FlowNodes nodes(c.Grid, { c.Mismatches, {} }, links, c.Donors, c.Parts.Group());
      std::vector<std::int64_t> count{ static_cast<std::int64_t>(nodes.Owned()) };
      c.Parts.Group().Sum(count);
      EXPECT_EQ(count[0], 27);
      const FlowGraph& graph = nodes.Graph();
      EXPECT_EQ(nodes.Count(), nodes.Owned() + graph.Copies);
      for (std::size_t i = 0; i < nodes.Owned(); ++i)
      {
        const Index3& p = graph.Places[i];
        EXPECT_LE(Distance(p, mixed), 1);
        EXPECT_EQ(nodes.NodeOf(nodes.DonorAt(i)), static_cast<int>(i));
        for (int f = 0; f < 6; ++f)
        {
          Index3 q = p;
          q[f / 2] += f % 2 ? 1 : -1;
          const int other = graph.Nodes[i].Others[f];
          const Index cell = c.Grid.Linear(Distance(q, mixed) <= 1 ? q : p);
          EXPECT_EQ(c.Donors[nodes.DonorAt(other)].Cell, cell);
        }
      }
      std::vector<double> values(nodes.Count(), -1.0);
      for (std::size_t i = 0; i < nodes.Owned(); ++i)
      {
        values[i] = static_cast<double>(c.Grid.CellKey(graph.Places[i]));
      }
      graph.Update(values);
      for (std::size_t i = 0; i < nodes.Count(); ++i)
      {
        const Index cell = c.Donors[nodes.DonorAt(i)].Cell;
        EXPECT_EQ(values[i], static_cast<double>(c.Grid.CellKey(c.Grid.Position(cell))));
        EXPECT_EQ(graph.Pieces[i], 1);
      }
      EXPECT_EQ(ListFragments(graph), std::vector<int>(1, 1));
    });
}

/// Mismatch cells far apart divide the nodes of a fragment, so all its donors become nodes.
TEST(FlowNodes, DividedFragmentsHaveAllNodes)
{
  ForMixedCells({ { { 2, 2, 2 } }, { { 12, 2, 2 } } },
    [](MixedCells& c)
    {
      const DonorLinks links(c.Grid, c.Parts, c.Donors);
      const std::vector<int> divided =
        FindDivided(c.Grid, c.Mismatches, links, c.Donors, c.Parts.Group());
      ASSERT_EQ(divided, std::vector<int>{ 1 });
      FlowNodes few(c.Grid, { c.Mismatches, {} }, links, c.Donors, c.Parts.Group());
      EXPECT_EQ(ListFragments(few.Graph()), std::vector<int>(2, 1));
      FlowNodes all(c.Grid, { c.Mismatches, divided }, links, c.Donors, c.Parts.Group());
      EXPECT_EQ(static_cast<Index>(all.Owned()), c.Grid.Owned().NumberOfCells());
      EXPECT_EQ(ListFragments(all.Graph()), std::vector<int>(1, 1));
    });
}
