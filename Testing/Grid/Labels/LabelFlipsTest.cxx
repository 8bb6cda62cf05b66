/// Changes of labels, their gains and prices, and glued blocks at flat seams.
#include "Labels/LabelFlips.h"
#include "Labels/GlueBlocks.h"
#include "Labels/LabelCondition.h"
#include "MeshChecks.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Two cells of label 2 that touch along an edge, in label 1.
struct TwoCells
{
  static FractionField Fill(const CartesianGrid& grid)
  {
    FractionField fractions = MakeLabels(grid, 2,
      [](const Index3& p) {
        return p == Index3{ { 2, 2, 2 } } ? 2 : 1;
      });
    fractions.SetParts(grid.Linear({ { 3, 3, 2 } }), { { 1, 0.3 }, { 2, 0.7 } });
    return fractions;
  }
  Index CountAll() const
  {
    Index count = 0;
    ForCells({ {}, { { 7, 7, 7 } } },
      [&](const Index3& node)
      { count += CountViolations(StarOfNode(this->Grid, this->Labels, this->Grid.Linear(node))); });
    return count;
  }

  Runtime Run;
  const CartesianGrid Grid = MakeUnitGrid(6);
  const Partition Parts{ Grid, Run.Group() };
  const FractionField Fractions = Fill(Grid);
  LabelArray Labels = AssignMaterials(Grid, Fractions, 0.5);
};

} // namespace

TEST(LabelFlips, OfTwoCellsAtAnEdge)
{
  TwoCells c;
  LabelFlips flips{ c.Grid, c.Fractions, c.Labels, c.Parts, nullptr, false };
  flips.Violated = FindMixedNodes(c.Grid, c.Labels);
  KeepViolated(flips, c.Run);
  EXPECT_EQ(flips.Violated,
    (std::vector<Index>{ c.Grid.Linear({ { 3, 3, 2 } }), c.Grid.Linear({ { 3, 3, 3 } }) }));
  flips.Sizes = std::make_unique<LabelSizes>(c.Grid, c.Labels, 3, c.Parts);
  const IndexBox cell = BoxOfCell({ { 3, 3, 2 } });
  const Index before = c.CountAll();
  const std::vector<int> gains = FindGains(flips, cell, { 2, 1 });
  EXPECT_EQ(gains[0], 0);
  EXPECT_DOUBLE_EQ(Cost(flips, cell, 2, 1), 0.7 - 0.3);
  EXPECT_EQ(Cost(flips, cell, 1, 2), 0.0);
  EXPECT_DOUBLE_EQ(Price(flips, cell, 2, 1) / flips.Sizes->Factor(1, 2, 1), 0.05 + 0.4);
  ApplyChanges(flips, { { cell, 1 } }, {});
  EXPECT_EQ(gains[1], before - c.CountAll());
  EXPECT_GT(gains[1], 0);
  const Index changed = c.Grid.Linear(cell.Lower);
  EXPECT_EQ(c.Labels[changed], 1);
  ASSERT_EQ(flips.Original.size(), 1u);
  EXPECT_EQ(flips.Original.at(changed), 2);
  EXPECT_TRUE(flips.Sizes->IsLast(1, 2));
  KeepViolated(flips, c.Run);
  EXPECT_TRUE(flips.Violated.empty());
}

/// Gains are the violations that a change removes, of random labels.
TEST(LabelFlips, GainsAreViolationsLessThoseAfterTheChange)
{
  RandomDraw draw(7);
  TwoCells c;
  const auto cellAt = [&] { return static_cast<Index>(draw.Between(1.0, 4.99)); };
  const auto label = [&] { return static_cast<int>(draw.Between(0.0, 3.99)); };
  for (int time = 0; time < 60; ++time)
  {
    ForCells({ {}, { { 6, 6, 6 } } },
      [&](const Index3& cell) { c.Labels.Set(c.Grid.Linear(cell), label()); });
    const Index3 low{ { cellAt(), cellAt(), cellAt() } };
    const LabelFlips flips{ c.Grid, c.Fractions, c.Labels, c.Parts, nullptr, false };
    const std::vector<int> labels{ 3, 0, 1, 2 };
    const std::vector<int> gains = FindGains(flips, BoxOfCell(low), labels);
    const Index before = c.CountAll(), cell = c.Grid.Linear(low);
    const int first = c.Labels[cell];
    for (std::size_t n = 0; n < labels.size(); ++n)
    {
      c.Labels.Set(cell, labels[n]);
      EXPECT_EQ(gains[n], before - c.CountAll()) << time << " " << labels[n];
      c.Labels.Set(cell, first);
    }
  }
}

/// A box of cells costs what its cells cost; changes can be undone.
TEST(LabelFlips, OfABox)
{
  TwoCells c;
  LabelFlips flips{ c.Grid, c.Fractions, c.Labels, c.Parts, nullptr, false };
  flips.Sizes = std::make_unique<LabelSizes>(c.Grid, c.Labels, 3, c.Parts);
  const IndexBox box{ { { 3, 3, 2 } }, { { 4, 4, 4 } } };
  EXPECT_NEAR(Cost(flips, box, 1, 2), 2.0 * (0.65 - 0.35), 1e-15);
  ApplyChanges(flips, { { box, 2 } }, {});
  EXPECT_EQ(c.Labels[c.Grid.Linear({ { 3, 3, 3 } })], 2);
  EXPECT_EQ(flips.Violated.size(), 2u * 2 * 3); // all nodes of the box are on its surface
  EXPECT_EQ(flips.Original.size(), 1u);
}

/// Labels at random next to a flat seam break its condition at many nodes, but not after gluing.
TEST(GlueBlocks, NoLabelBreaksTheSeam)
{
  std::vector<double> x(9);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    x[i] = static_cast<double>(i);
  }
  const CartesianGrid grid = CartesianGrid::Covering(
    { { x, x, x } }, { {}, { { 8, 8, 8 } } }, { { true, false, false } }, Seam::Flat, GhostLayers);
  Runtime runtime;
  const Partition partition(grid, runtime.Group());
  const Index first = grid.Domain().Lower[0];
  const FractionField fractions = MakeLabels(grid, 2,
    [&](const Index3& p)
    {
      const Index3 own = grid.Canonical(p);
      const Index i = own[0] - first;
      RandomDraw random(static_cast<unsigned>(grid.CellKey(own)));
      random.Seed();
      return i == 0 || i == 7 ? random.Whole(1, 2) : i < 4 ? 1 : 2;
    });
  LabelArray labels = AssignMaterials(grid, fractions, 0.5);
  const LabelArray before = labels;
  LabelFlips flips{ grid, fractions, labels, partition, nullptr, true };
  const auto countBroken = [&]
  {
    int count = 0;
    for (Index node : FindMixedNodes(grid, labels))
    {
      const Index3 p = grid.Position(node);
      count += grid.Domain().Contains(p)
        ? CountSeamViolations(StarOfNode(grid, labels, node), grid.FlatSeams(p))
        : 0;
    }
    return count;
  };
  EXPECT_GT(countBroken(), 50);
  flips.Violated = FindMixedNodes(grid, labels);
  KeepViolated(flips, runtime);
  flips.Sizes = std::make_unique<LabelSizes>(grid, labels, 3, partition);
  EXPECT_GT(GlueBlocks(flips, runtime), 0);
  EXPECT_EQ(countBroken(), 0);
  Index changed = 0;
  ForCells(grid.Domain(),
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p), i = p[0] - first;
      const bool isChanged = labels[cell] != before[cell];
      EXPECT_TRUE(!isChanged || i == 0 || i == 7);
      changed += isChanged;
    });
  EXPECT_GT(changed, 0);
  EXPECT_LT(changed, 64);
  EXPECT_EQ(GlueBlocks(flips, runtime), 0);
}
