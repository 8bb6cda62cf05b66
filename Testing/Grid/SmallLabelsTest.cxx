/// Small labels survive the flips of cells, and small fragments get their volumes.
#include "Atlas.h"
#include "Labels/LabelCondition.h"
#include "Labels/LeafLabels.h"
#include "Labels/ResolveLabels.h"
#include "Labels/SmoothLabels.h"
#include "MeshCases.h"
#include "Phases/MeshOfCells.h"
#include "RandomDraw.h"
#include "RankMeshes.h"
#include "Sweep.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int SmoothingPasses = 3;

FractionField Smoothed(const CartesianGrid& grid, FractionField labels)
{
  Runtime runtime;
  SmoothLabels(grid, SmoothingPasses, Partition(grid, runtime.Group()), runtime, labels);
  return labels;
}

LabelArray Resolved(const CartesianGrid& grid, const FractionField& fractions)
{
  Runtime runtime;
  LabelArray labels = AssignMaterials(grid, fractions, 0.5);
  ResolveLabels(grid, fractions, labels, Partition(grid, runtime.Group()), runtime);
  return labels;
}

std::vector<Index> CountCells(const CartesianGrid& grid, const LabelArray& labels, int materials)
{
  std::vector<Index> cells(materials + 1, 0);
  ForCells(grid.Owned(), [&](const Index3& p) { ++cells[labels[grid.Linear(p)]]; });
  return cells;
}

/// Returns two halves of label 1 and 2, with scattered cells of label 3 and 4 in their middle.
/// @param share  share of label 4, and of label 3, in the middle
FractionField MakeScattered(const CartesianGrid& grid, unsigned seed, double share)
{
  RandomDraw draw(seed);
  const Index n = grid.Global().Size(0);
  std::vector<double> random;
  ForCells(grid.Global(), [&](const Index3&) { random.push_back(draw.Between(0.0, 1.0)); });
  return MakeLabels(grid, 4,
    [&](const Index3& p)
    {
      const bool isMiddle =
        std::all_of(p.begin(), p.end(), [n](Index i) { return i >= 4 && i < n - 4; });
      const double r = isMiddle ? random[IndexInBox(grid.Global(), p)] : 1.0;
      const int half = p[0] < n / 2 ? 1 : 2;
      return r < share ? 4 : (r < 2.0 * share ? 3 : half);
    });
}

void ExpectVolumes(const MeshReport& report, double error)
{
  for (int m = 1; m <= 4; ++m)
  {
    std::printf("label %d: volume %.4f of %.0f\n", m, report.MeshVolume[m], report.TargetVolume[m]);
    EXPECT_NEAR(report.MeshVolume[m], report.TargetVolume[m], error * report.TargetVolume[m]);
  }
}

/// Counts the violations at the nodes of a cell if the cell has the given label.
int CountViolationsAround(
  const CartesianGrid& grid, const LabelArray& labels, const Index3& cell, int label)
{
  const IndexBox box{ cell, CornerOfCell(cell, 7) };
  LabelArray changed = labels;
  FillLabels(grid, box, label, changed);
  int violations = 0;
  ForCells(NodesOf(box),
    [&](const Index3& node)
    { violations += CountViolations(StarOfNode(grid, changed, grid.Linear(node))); });
  return violations;
}

} // namespace

/// Two cells of label 2 touch along an edge: a cell of the surrounding
/// label can be flipped instead.
TEST(SmallLabels, PairThatTouchesAlongAnEdgeStays)
{
  const CartesianGrid grid = MakeUnitGrid(12);
  const FractionField field = MakeLabels(grid, 2,
    [](const Index3& p) {
      return p == Index3{ { 5, 5, 5 } } || p == Index3{ { 6, 6, 5 } } ? 2 : 1;
    });
  const LabelArray labels = Resolved(grid, field);
  EXPECT_EQ(labels[grid.Linear({ { 5, 5, 5 } })], 2);
  EXPECT_EQ(labels[grid.Linear({ { 6, 6, 5 } })], 2);
  EXPECT_EQ(CountCells(grid, labels, 2)[2], 3);
}

/// Each crowd has 40 labels. Where two single cells conflict, one of them may be lost.
TEST(SmallLabels, LastCellsStay)
{
  int singles = 0, lostSingles = 0;
  for (unsigned seed : ListSeeds(10))
  {
    const CartesianGrid grid = MakeUnitGrid(20);
    const FractionField atlas = MakeAtlas(grid, 40, seed);
    const int materials = atlas.NumberOfMaterials();
    const std::vector<Index> before =
      CountCells(grid, AssignMaterials(grid, atlas, 0.5), materials);
    const std::vector<Index> after = CountCells(grid, Resolved(grid, atlas), materials);
    for (int m = 1; m <= materials; ++m)
    {
      const bool isSingle = before[m] == 1;
      singles += isSingle;
      lostSingles += isSingle && after[m] == 0;
      EXPECT_TRUE(isSingle || after[m] > 0)
        << "label " << m << " of " << before[m] << " cells, seed " << seed;
    }
  }
  std::printf("%d of %d labels of one cell lost\n", lostSingles, singles);
  if (IsWholeSweep())
  {
    EXPECT_GT(singles, 20);
    EXPECT_LE(20 * lostSingles, singles);
  }
}

TEST(SmallLabels, NoFlipIsInVain)
{
  Index flips = 0;
  for (unsigned seed : ListSeeds(5))
  {
    const CartesianGrid grid = MakeUnitGrid(9, 8, 7);
    const FractionField field = MakeRandomLabels(grid, 3, 0, seed);
    const LabelArray labels = Resolved(grid, field);
    ForCells(grid.Owned(),
      [&](const Index3& p)
      {
        const Index cell = grid.Linear(p);
        const int first = field.Label(cell);
        if (labels[cell] != first)
        {
          ++flips;
          EXPECT_GT(CountViolationsAround(grid, labels, p, first), 0) << "seed " << seed;
        }
      });
  }
  EXPECT_GT(flips, 100);
}

/// Fragments of one cell, and of three cells in an angle, get their volumes as large ones do.
TEST(SmallLabels, SingleCellsGetTheirVolume)
{
  const CartesianGrid grid = MakeUnitGrid(14);
  const FractionField labels = MakeLabels(grid, 3,
    [](const Index3& p)
    {
      const bool isAngle = p[2] == 8 && p[0] >= 8 && p[1] >= 8 && p[0] + p[1] <= 17;
      return p == Index3{ { 3, 4, 3 } } ? 2 : (isAngle ? 3 : (p[0] < 12 ? 1 : 0));
    });
  Runtime runtime;
  MeshReport report;
  MakeHexMesh(grid, Smoothed(grid, labels), MeshOptions(), runtime, report);
  for (int m : { 1, 2, 3 })
  {
    std::printf("label %d: volume %.6f of %.6f\n", m, report.MeshVolume[m], report.TargetVolume[m]);
    EXPECT_NEAR(report.MeshVolume[m], report.TargetVolume[m], 1e-2 * report.TargetVolume[m]);
  }
  EXPECT_GT(report.MinimumScaledJacobian, 0.45);
}

/// Fragments of one or two cells that cannot reach their targets neither keep their neighbours off
/// their volumes nor their label.
TEST(SmallLabels, ScatteredLabelsGetTheirVolumes)
{
  const CartesianGrid grid = MakeUnitGrid(18);
  Runtime runtime;
  MeshReport report;
  for (double share : { 0.1, 0.3 })
  {
    const FractionField labels = MakeScattered(grid, 4, share);
    const Mesh mesh = MakeHexMesh(grid, labels, MeshOptions(), runtime, report);
    ExpectVolumes(report, 0.01);
    EXPECT_GT(report.MinimumScaledJacobian, 0.42);
    EXPECT_TRUE(IsPositiveEverywhere(mesh));
    for (TetMethod method : { TetMethod::Lattice, TetMethod::Cells })
    {
      MeshOptions options;
      options.Method = method;
      EXPECT_TRUE(IsPositiveEverywhere(MakeTetMesh(grid, labels, options, runtime, report)));
      ExpectVolumes(report, method == TetMethod::Cells ? 0.025 : 0.01);
    }
  }
}

/// Each flip is counted for the label that lost the cell, and for the one that gained it.
TEST(SmallLabels, FlipsAreCountedPerLabel)
{
  const CartesianGrid grid = MakeUnitGrid(18);
  const FractionField fractions = MakeScattered(grid, 1, 0.2);
  const LabelArray before = AssignMaterials(grid, fractions, 0.5);
  LabelArray after = before;
  Runtime runtime;
  const ResolveReport report =
    ResolveLabels(grid, fractions, after, Partition(grid, runtime.Group()), runtime);
  std::vector<Index> lost(5, 0), gained(5, 0);
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p);
      lost[before[cell]] += before[cell] != after[cell];
      gained[after[cell]] += before[cell] != after[cell];
    });
  EXPECT_EQ(report.LostCells, lost);
  EXPECT_EQ(report.GainedCells, gained);
  EXPECT_EQ(report.FlippedCells, std::accumulate(lost.begin(), lost.end(), Index{ 0 }));
  EXPECT_GT(lost[3], 10);
}

TEST(SmallLabels, AtlasKeepsLabelsAndVolumes)
{
  const CartesianGrid grid = MakeUnitGrid(48);
  const FractionField labels = MakeAtlas(grid, 60, 1);
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = MakeHexMesh(grid, Smoothed(grid, labels), MeshOptions(), runtime, report);
  const std::vector<AtlasClass> classes = MeasureAtlas(grid, labels, report);
  std::printf(
    "%lld flips\n%s", static_cast<long long>(report.FlippedCells), FormatAtlas(classes).c_str());
  for (const AtlasClass& c : classes)
  {
    EXPECT_GT(c.Labels, 0) << c.Smallest;
    EXPECT_EQ(c.Lost, 0) << c.Smallest;
    EXPECT_LT(c.MeanError, c.Smallest >= 8 ? 5e-3 : 0.1) << c.Smallest;
    EXPECT_LT(c.WorstError, c.Smallest >= 500 ? 5e-4 : (c.Smallest >= 8 ? 0.03 : 1.0))
      << c.Smallest;
  }
  EXPECT_GT(report.MinimumScaledJacobian, 0.4);
  EXPECT_TRUE(IsPositiveEverywhere(mesh));
}

TEST(SmallLabels, RanksAgree)
{
  const CartesianGrid grid = MakeUnitGrid(20);
  CompareWithSerial(grid, Smoothed(grid, MakeAtlas(grid, 20, 3)),
    { CutBox(grid.Global(), 2), CutBox(grid.Global(), 3, 0), CutBox(grid.Global(), 8) },
    MeshOptions());
  // Here fragments resist.
  const CartesianGrid small = MakeUnitGrid(18);
  CompareWithSerial(small, MakeScattered(small, 4, 0.1),
    { CutBox(small.Global(), 2), CutBox(small.Global(), 3, 0), CutBox(small.Global(), 8) },
    MeshOptions());
}
