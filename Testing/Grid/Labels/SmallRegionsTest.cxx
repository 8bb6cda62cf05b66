/// Small regions are removed: fragments, cavities, noise, droplets; ranks agree.
#include "Labels/SmallRegions.h"
#include "Labels/Labels.h"
#include "MeshChecks.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

RemovedRegions Remove(
  const CartesianGrid& grid, Index minimum, FractionField& field, double isoValue = 0.5)
{
  Runtime runtime;
  return RemoveSmallRegions(grid, minimum, isoValue, Partition(grid, runtime.Group()), field);
}

FieldChange RemoveBelow(Index minimum)
{
  return [minimum](const CartesianGrid& grid, const Partition& partition, Runtime&,
           FractionField& fractions)
  { RemoveSmallRegions(grid, minimum, 0.5, partition, fractions); };
}

/// Returns the number of cells of the smallest region, found cell by cell.
Index FindSmallestRegion(
  const CartesianGrid& grid, const FractionField& field, double isoValue = 0.5)
{
  const LabelArray labels = AssignMaterials(grid, field, isoValue);
  std::vector<unsigned char> seen(grid.NumberOfEntries(), 0);
  Index smallest = grid.Global().NumberOfCells();
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      std::vector<Index3> open;
      Index count = 0;
      const auto visit = [&](const Index3& q)
      {
        if (grid.InDomain(q) && !seen[grid.Linear(q)] &&
          labels[grid.Linear(q)] == labels[grid.Linear(p)])
        {
          seen[grid.Linear(q)] = 1;
          open.push_back(q);
          ++count;
        }
      };
      for (visit(p); !open.empty();)
      {
        const Index3 q = open.back();
        open.pop_back();
        for (int face = 0; face < 6; ++face)
        {
          Index3 next = q;
          next[face / 2] += (face & 1) ? 1 : -1;
          visit(next);
        }
      }
      smallest = count > 0 ? std::min(smallest, count) : smallest;
    });
  return smallest;
}

/// Returns the label of a cell: blocks of materials 1 and 2 side by side in void. The first
/// contains a cavity of three cells and a single cell of 2. A pair of cells of 1 lies in the void,
/// a cell of 3 at the common face of the blocks.
int CrumbAt(const Index3& p)
{
  const bool inFirst = p[0] >= 2 && p[0] < 8 && p[1] >= 2 && p[1] < 10 && p[2] >= 2 && p[2] < 10;
  const bool inSecond = p[0] >= 8 && p[0] < 13 && p[1] >= 2 && p[1] < 10 && p[2] >= 2 && p[2] < 10;
  if (p[1] == 5 && p[2] == 5 && p[0] >= 3 && p[0] < 6)
  {
    return 0;
  }
  if (p == Index3{ { 5, 7, 7 } })
  {
    return 2;
  }
  if (p[0] >= 13 && p[0] < 15 && p[1] == 12 && p[2] == 12)
  {
    return 1;
  }
  if (p == Index3{ { 8, 7, 4 } })
  {
    return 3; // five faces to 2, one to 1
  }
  return inFirst ? 1 : (inSecond ? 2 : 0);
}

TEST(SmallRegions, Crumbs)
{
  const CartesianGrid grid = MakeUnitGrid(16, 14, 14);
  const FractionField labels = MakeLabels(grid, 3, CrumbAt);
  FractionField field = labels;
  EXPECT_EQ(Remove(grid, 1, field).Regions, 0);
  const RemovedRegions two = Remove(grid, 2, field);
  EXPECT_EQ(two.Regions, 2);
  EXPECT_EQ(two.Cells, 2);
  EXPECT_EQ(field.Label(grid.Linear({ { 5, 7, 7 } })), 1);
  EXPECT_EQ(field.Label(grid.Linear({ { 8, 7, 4 } })), 2);
  EXPECT_EQ(field.Label(grid.Linear({ { 4, 5, 5 } })), 0);
  field = labels;
  const RemovedRegions four = Remove(grid, 4, field);
  EXPECT_EQ(four.Regions, 4);
  EXPECT_EQ(four.Cells, 7);
  EXPECT_EQ(field.Label(grid.Linear({ { 4, 5, 5 } })), 1);
  EXPECT_EQ(field.Label(grid.Linear({ { 13, 12, 12 } })), 0);
  EXPECT_EQ(FindSmallestRegion(grid, field), 5 * 8 * 8);
  for (Index minimum : { 2, 3, 4, 400 })
  {
    EXPECT_EQ(FindRankProblem(grid, labels, RemoveBelow(minimum)), "") << minimum;
  }
}

TEST(SmallRegions, TiesGoToTheSmallerNumber)
{
  const CartesianGrid grid = MakeUnitGrid(3, 1, 1);
  FractionField field =
    MakeLabels(grid, 3, [](const Index3& p) { return 3 - static_cast<int>(p[0]); });
  EXPECT_EQ(Remove(grid, 2, field).Regions, 2); // 3 joins 2, now two cells; 1 joins it
  for (Index i = 0; i < 3; ++i)
  {
    EXPECT_EQ(field.Label(grid.Linear({ { i, 0, 0 } })), 2);
  }
  field = MakeLabels(
    MakeUnitGrid(5, 1, 1), 3, [](const Index3& p) { return p[0] == 2 ? 3 : (p[0] < 2 ? 2 : 1); });
  Remove(MakeUnitGrid(5, 1, 1), 2, field);
  EXPECT_EQ(field.Label(MakeUnitGrid(5, 1, 1).Linear({ { 2, 0, 0 } })), 1);
}

TEST(SmallRegions, TheWholeDomainStays)
{
  const CartesianGrid grid = MakeUnitGrid(3);
  for (int lowest : { 0, 1 })
  {
    FractionField field = MakeLabels(grid, 1, [lowest](const Index3&) { return lowest; });
    EXPECT_EQ(Remove(grid, 1000, field).Regions, 0);
    EXPECT_EQ(field.Label(grid.Linear({ { 1, 1, 1 } })), lowest);
  }
  FractionField noise = MakeRandomLabels(grid, 2, 0, 3);
  Remove(grid, 1000, noise); // one region is left
  EXPECT_EQ(FindSmallestRegion(grid, noise), 27);
}

TEST(SmallRegions, NoiseHasNoSmallRegions)
{
  for (int seed : { 1, 2, 3 })
  {
    const CartesianGrid grid = seed == 1 ? MakeUnitGrid(16) : MakeUnitGrid(11, 7, 19);
    const FractionField noise = MakeRandomLabels(grid, 3, 0, seed);
    ASSERT_EQ(FindSmallestRegion(grid, noise), 1);
    FractionField field = noise;
    const RemovedRegions removed = Remove(grid, 8, field);
    EXPECT_GE(FindSmallestRegion(grid, field), 8);
    Index changed = 0;
    ForCells(grid.Global(),
      [&](const Index3& p)
      { changed += field.Label(grid.Linear(p)) != noise.Label(grid.Linear(p)); });
    EXPECT_EQ(removed.Cells, changed);
    EXPECT_EQ(Remove(grid, 8, field).Regions, 0);
    EXPECT_EQ(FindRankProblem(grid, noise, RemoveBelow(8)), "");
  }
}

TEST(SmallRegions, RandomFractions)
{
  for (int seed : { 1, 2, 3, 4 })
  {
    const CartesianGrid grid = seed % 2 ? MakeUnevenGrid(9) : MakeUnitGrid(13, 8, 6);
    const FractionField random = MakePatchyFractions(grid, 3, seed);
    for (double isoValue : { 0.5, 0.2, 0.8 })
    {
      FractionField field = random;
      Remove(grid, 8, field, isoValue);
      EXPECT_GE(FindSmallestRegion(grid, field, isoValue), 8) << "iso value " << isoValue;
    }
    EXPECT_EQ(FindRankProblem(grid, random, RemoveBelow(8)), "");
  }
}

/// Islands of small regions over many ranks. Nothing is gathered.
TEST(SmallRegions, ManyRanksAgree)
{
  const CartesianGrid whole = MakeUnitGrid(15, 14, 13);
  const FractionField noise = MakeRandomLabels(whole, 4, 0, 9);
  FractionField expected = noise;
  const RemovedRegions removed = Remove(whole, 12, expected);
  EXPECT_GT(removed.Regions, 500);
  for (int count : { 5, 27 })
  {
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), count);
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        const Partition partition(grid, ranks);
        FractionField field = CopyToLocal(whole, noise, grid);
        const std::int64_t gathered = ranks.Sent().GatheredBytes;
        const RemovedRegions own = RemoveSmallRegions(grid, 12, 0.5, partition, field);
        EXPECT_EQ(ranks.Sent().GatheredBytes, gathered);
        EXPECT_EQ(own.Regions, removed.Regions);
        EXPECT_EQ(own.Cells, removed.Cells);
        Index differences = 0;
        ForCells(grid.Local(),
          [&](const Index3& p)
          { differences += !HaveSameParts(field, grid.Linear(p), expected, whole.Linear(p)); });
        EXPECT_EQ(differences, 0) << count << " ranks";
      });
  }
}

/// Water with an oblique surface, and two droplets above it. One droplet fills two cells by more
/// than half and is removed, the other fills none and stays.
TEST(SmallRegions, SprayGoesWithAllItsFractions)
{
  const CartesianGrid grid = MakeUnitGrid(10);
  FractionField field(grid, 1);
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      const double level = 3.0 + 0.1 * p[0];
      const double fraction = std::min(std::max(level - p[2], 0.0), 1.0);
      if (fraction > 0.0)
      {
        field.SetParts(grid.Linear(p), { { 1, fraction } });
      }
    });
  for (const auto& cell :
    std::vector<std::pair<Index3, double>>{ { { { 4, 4, 7 } }, 0.9 }, { { { 5, 4, 7 } }, 0.7 },
      { { { 6, 4, 7 } }, 0.3 }, { { { 5, 5, 8 } }, 0.2 }, { { { 1, 8, 8 } }, 0.4 } })
  {
    field.SetParts(grid.Linear(cell.first), { { 1, cell.second } });
  }
  const FractionField before = field;
  const RemovedRegions removed = Remove(grid, 3, field);
  EXPECT_EQ(removed.Regions, 1);
  EXPECT_EQ(removed.Cells, 2);
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p);
      const bool isGone = p[2] >= 7 && p[0] >= 3 && p != Index3{ { 1, 8, 8 } };
      EXPECT_EQ(field.Fraction(cell, 1), isGone ? 0.0 : before.Fraction(cell, 1));
    });
  EXPECT_EQ(FindRankProblem(grid, before, RemoveBelow(3)), "");
}

} // namespace
