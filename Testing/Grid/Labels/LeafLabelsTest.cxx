/// Labels of leaves follow mean fractions and are equal within each leaf. Every star is accepted;
/// labels are the same on any ranks.
#include "RankMeshes.h"
#include "Sweep.h"

#include "Fractions/FractionSum.h"
#include "Labels/LabelCondition.h"
#include "Labels/LeafLabels.h"
#include "Labels/ResolveLabels.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double IsoValue = 0.5;

/// The levels of the whole grid, or of the part of a rank.
struct LeafGrid
{
  LeafGrid(CartesianGrid grid, const LevelPlan& plan, Ranks& ranks) :
    Finest(std::move(grid)), Levels(this->Finest, plan, {}, ranks)
  {
  }
  LabelArray Assign(const FractionField& fractions) const
  {
    return AssignLeafMaterials(
      this->Levels, fractions, AssignMaterials(this->Finest, fractions, IsoValue), IsoValue);
  }
  ResolveReport Resolve(const FractionField& fractions, Ranks& ranks, LabelArray& labels) const
  {
    RankRuntime runtime(ranks);
    return ResolveLabels(
      this->Finest, fractions, labels, Partition(this->Finest, ranks), runtime, &this->Levels);
  }
  Index3 LowestOfLeaf(const Index3& cell) const
  {
    const OctreeKeys::LevelIndex leaf = this->Levels.LeafOf(cell);
    return this->Levels.FinestCells(leaf.Level, leaf.At).Lower;
  }

  const CartesianGrid Finest;
  const RefinedGrid Levels;
};

LevelPlan MakePlan(int refinements, std::vector<std::vector<Index>> families)
{
  LevelPlan plan;
  plan.Refinements = refinements;
  plan.FineInterfaces = false;
  plan.Families = std::move(families);
  return plan;
}

/// Refines the families of the last level for which isRequested(lowest finest cell) is true.
LevelPlan MakePlan(
  const CartesianGrid& grid, int refinements, const std::function<bool(const Index3&)>& isRequested)
{
  std::vector<std::vector<Index>> families(refinements);
  IndexBox box;
  for (int a = 0; a < 3; ++a)
  {
    box.Upper[a] = (grid.Global().Upper[a] / 2 + 1) / 2;
  }
  ForCells(box,
    [&](const Index3& q)
    {
      if (isRequested({ { 4 * q[0], 4 * q[1], 4 * q[2] } }))
      {
        families.back().push_back(IndexInBox(box, q));
      }
    });
  return MakePlan(refinements, std::move(families));
}

/// Returns an empty string, or the first problem: labels that differ within a leaf or from the
/// mirrored label, or a rejected star.
std::string FindLabelProblem(const LeafGrid& levels, const LabelArray& labels)
{
  const CartesianGrid& grid = levels.Finest;
  std::string problem;
  const auto report = [&](const char* what, const Index3& p)
  {
    problem = std::string(what) + " at " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " +
      std::to_string(p[2]);
  };
  IndexBox wide = grid.Local();
  for (int a = 0; a < 3; ++a)
  {
    --wide.Lower[a];
    ++wide.Upper[a];
  }
  ForCells(wide,
    [&](const Index3& p)
    {
      const Index3 inside = grid.Position(LabelUnits(grid, nullptr).UnitOf(p));
      if (labels[grid.Linear(p)] != labels[grid.Linear(inside)])
      {
        report("no mirror", p);
      }
      if (labels[grid.Linear(inside)] != labels[grid.Linear(levels.LowestOfLeaf(inside))])
      {
        report("differ within a leaf", inside);
      }
    });
  for (Index node : FindMixedNodes(grid, labels))
  {
    if (CountViolations(StarOfNode(grid, labels, node)) != 0)
    {
      report("violated star", grid.Position(node));
    }
  }
  return problem;
}

/// Counts the leaves whose label changed; only coarser leaves if coarseAlone.
Index CountFlips(const LeafGrid& levels, const LabelArray& before, const LabelArray& after,
  bool coarseAlone = false)
{
  Index count = 0;
  ForCells(levels.Finest.Owned(),
    [&](const Index3& p)
    {
      const Index cell = levels.Finest.Linear(p);
      count += levels.LowestOfLeaf(p) == p && before[cell] != after[cell] &&
        !(coarseAlone && levels.Levels.IsFine(p));
    });
  return count;
}

/// Counts the leaves at mixed nodes.
Index CountMixedLeaves(const LeafGrid& levels, const LabelArray& labels)
{
  const LabelUnits units(levels.Finest, &levels.Levels);
  std::vector<Index> leaves;
  for (Index node : FindMixedNodes(levels.Finest, labels))
  {
    for (int s = 0; s < 8; ++s)
    {
      leaves.push_back(units.UnitOf(CellOfStar(levels.Finest.Position(node), s)));
    }
  }
  std::sort(leaves.begin(), leaves.end());
  return std::unique(leaves.begin(), leaves.end()) - leaves.begin();
}

/// Returns the volume times fraction of each material, void first, summed over a box of
/// cells, and the volume of the box.
std::pair<std::vector<double>, double> SumFractions(
  const CartesianGrid& grid, const FractionField& fractions, const IndexBox& cells)
{
  std::pair<std::vector<double>, double> sums(
    std::vector<double>(fractions.NumberOfMaterials() + 1, 0.0), 0.0);
  ForCells(cells,
    [&](const Index3& p)
    {
      sums.second += grid.CellVolume(p);
      for (std::size_t m = 0; m < sums.first.size(); ++m)
      {
        sums.first[m] +=
          grid.CellVolume(p) * fractions.Fraction(grid.Linear(p), static_cast<int>(m));
      }
    });
  return sums;
}

/// Returns one of three kinds of random fractions: labels in cells, labels in blocks, mixed cells.
FractionField MakeFractions(const CartesianGrid& grid, int materials, unsigned seed)
{
  if (seed % 3 == 0)
  {
    return MakeRandomLabels(grid, materials, 0, seed);
  }
  if (seed % 3 == 1)
  {
    return MakePatchyFractions(grid, materials, seed);
  }
  return MakeLabels(grid, materials,
    [&](const Index3& p)
    {
      std::mt19937 random(static_cast<unsigned>(
        seed + 1000 * (p[0] / 4) + 100000 * (p[1] / 4) + 10000000 * (p[2] / 4)));
      return static_cast<int>(random() % (materials + 1));
    });
}

struct RandomCase
{
  int Refinements, Materials;
};

void PrintTo(const RandomCase& c, std::ostream* out)
{
  *out << c.Refinements << " refinements, " << c.Materials << " materials";
}

class RandomLeaves : public ::testing::TestWithParam<RandomCase>
{
};

/// Returns a part of MakeUnevenGrid.
CartesianGrid MakeUnevenBox(const Index3& cells)
{
  const CartesianGrid grid =
    MakeUnevenGrid(static_cast<int>(*std::max_element(cells.begin(), cells.end())));
  std::array<std::vector<double>, 3> x;
  for (int a = 0; a < 3; ++a)
  {
    x[a].assign(grid.Coordinates(a).begin(), grid.Coordinates(a).begin() + cells[a] + 1);
  }
  return CartesianGrid(x);
}

LevelPlan MakeRandomPlan(const CartesianGrid& grid, int refinements, unsigned seed)
{
  return MakePlan(refinements, MakeRandomFamilies(grid, refinements, .02 * (seed % 8), seed));
}

} // namespace

TEST_P(RandomLeaves, LabelsAreThoseOfTheMeans)
{
  const int refinements = this->GetParam().Refinements, materials = this->GetParam().Materials;
  for (unsigned seed : ListSeeds(12))
  {
    SCOPED_TRACE(seed);
    Runtime runtime;
    const CartesianGrid whole = MakeUnevenGrid(4 << refinements);
    const LeafGrid levels(whole, MakeRandomPlan(whole, refinements, seed), runtime.Group());
    const CartesianGrid& grid = levels.Finest;
    const FractionField fractions = MakeFractions(grid, materials, seed);
    const LabelArray labels = levels.Assign(fractions);
    const LabelArray ofCells = AssignMaterials(grid, fractions, IsoValue);
    Index wrong = 0;
    ForCells(grid.Global(),
      [&](const Index3& p)
      {
        const int label = labels[grid.Linear(p)];
        wrong += label != labels[grid.Linear(levels.LowestOfLeaf(p))];
        if (levels.Levels.IsFine(p))
        {
          wrong += label != ofCells[grid.Linear(p)];
          return;
        }
        const OctreeKeys::LevelIndex leaf = levels.Levels.LeafOf(p);
        const IndexBox cells = levels.Levels.FinestCells(leaf.Level, leaf.At);
        const auto sums = SumFractions(grid, fractions, cells);
        const double small = 1e-12 * sums.second;
        const auto largest = std::max_element(sums.first.begin() + 1, sums.first.end());
        wrong += label == 0 ? sums.first[0] < (1.0 - IsoValue) * sums.second - small
                            : sums.first[0] > (1.0 - IsoValue) * sums.second + small ||
            sums.first[label] < *largest - small;
        wrong += std::abs(MeanOfCells(grid, fractions, cells).Fraction(label) * sums.second -
                   sums.first[label]) > small;
      });
    EXPECT_EQ(wrong, 0);
  }
}

TEST_P(RandomLeaves, AreResolved)
{
  const int refinements = this->GetParam().Refinements, materials = this->GetParam().Materials;
  Index flips = 0, coarse = 0;
  int rounds = 0;
  for (unsigned seed : ListSeeds(18))
  {
    SCOPED_TRACE(seed);
    const Index base = 3 + seed % 4;
    const CartesianGrid grid = MakeUnevenBox(
      { { base << refinements, (base + seed % 2) << refinements, (2 + seed % 3) << refinements } });
    Runtime runtime;
    const LeafGrid levels(grid, MakeRandomPlan(grid, refinements, seed), runtime.Group());
    const FractionField fractions = MakeFractions(levels.Finest, materials, seed);
    LabelArray labels = levels.Assign(fractions);
    const LabelArray before = labels;
    const ResolveReport report = levels.Resolve(fractions, runtime.Group(), labels);
    ASSERT_EQ(FindLabelProblem(levels, labels), "");
    EXPECT_EQ(report.FlippedCells, CountFlips(levels, before, labels));
    flips += report.FlippedCells;
    coarse += CountFlips(levels, before, labels, true);
    rounds = std::max(rounds, report.Rounds);
  }
  std::printf("%lld leaves flipped, %lld of them coarser ones, at most %d rounds\n",
    static_cast<long long>(flips), static_cast<long long>(coarse), rounds);
  if (IsWholeSweep())
  {
    EXPECT_GT(coarse, 0);
    EXPECT_GT(flips, coarse);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, RandomLeaves,
  ::testing::Values(RandomCase{ 1, 1 }, RandomCase{ 1, 2 }, RandomCase{ 1, 3 }, RandomCase{ 2, 1 },
    RandomCase{ 2, 2 }, RandomCase{ 2, 3 }));

TEST(LeafLabels, OfFineCellsOnlyAreThoseOfCells)
{
  for (unsigned seed : ListSeeds(6))
  {
    SCOPED_TRACE(seed);
    Runtime runtime;
    const LeafGrid levels(MakeUnevenGrid(12),
      MakePlan(MakeUnevenGrid(12), 2, [](const Index3&) { return true; }), runtime.Group());
    const FractionField fractions = MakeFractions(levels.Finest, 3, seed);
    LabelArray labels = levels.Assign(fractions);
    LabelArray ofCells = AssignMaterials(levels.Finest, fractions, IsoValue);
    const ResolveReport report = levels.Resolve(fractions, runtime.Group(), labels);
    const ResolveReport reportOfCells = ResolveLabels(
      levels.Finest, fractions, ofCells, Partition(levels.Finest, runtime.Group()), runtime);
    EXPECT_EQ(report.FlippedCells, reportOfCells.FlippedCells);
    EXPECT_EQ(report.Rounds, reportOfCells.Rounds);
    Index differences = 0;
    for (Index cell = 0; cell < levels.Finest.NumberOfEntries(); ++cell)
    {
      differences += labels[cell] != ofCells[cell];
    }
    EXPECT_EQ(differences, 0);
  }
}

/// With shapes larger than their cells hardly any leaf flips, even where levels meet.
TEST(LeafLabels, OfSmoothShapesHardlyFlip)
{
  for (const MeshCase& c : { MakeSphereCase(42), MakePolycrystalCase(8, 48) })
  {
    for (int refinements = 1; refinements <= 2; ++refinements)
    {
      SCOPED_TRACE(c.Name);
      Runtime runtime;
      const LeafGrid levels(c.Grid,
        MakePlan(c.Grid, refinements, [](const Index3& p) { return p[0] < 24; }), runtime.Group());
      LabelArray labels = levels.Assign(c.Fractions);
      const Index leaves = CountMixedLeaves(levels, labels);
      const ResolveReport report = levels.Resolve(c.Fractions, runtime.Group(), labels);
      EXPECT_EQ(FindLabelProblem(levels, labels), "");
      std::printf("%-20s %d refinements: %lld of %lld leaves at interfaces flipped\n",
        c.Name.c_str(), refinements, static_cast<long long>(report.FlippedCells),
        static_cast<long long>(leaves));
      EXPECT_LT(report.FlippedCells, 0.01 * static_cast<double>(leaves));
    }
  }
}

namespace
{

struct RankCase
{
  int Refinements, Ranks, Axis;
};

void PrintTo(const RankCase& c, std::ostream* out)
{
  *out << c.Refinements << " refinements, " << c.Ranks << " ranks";
}

class LeafRanks : public ::testing::TestWithParam<RankCase>
{
};

} // namespace

TEST_P(LeafRanks, HaveTheLabelsOfOne)
{
  const RankCase& c = this->GetParam();
  for (unsigned seed : ListSeeds(3))
  {
    SCOPED_TRACE(seed);
    const CartesianGrid whole = // longer than the ghost layers
      MakeUnevenBox({ { 4 << c.Refinements, 4 << c.Refinements, 16 << c.Refinements } });
    const FractionField field = MakeFractions(whole, 1 + seed % 3, seed);
    const LevelPlan plan = MakeRandomPlan(whole, c.Refinements, seed);
    Runtime alone;
    const LeafGrid levels(whole, plan, alone.Group());
    LabelArray expected = levels.Assign(field);
    const ResolveReport report = levels.Resolve(field, alone.Group(), expected);
    std::vector<IndexBox> boxes = CutBaseBox(whole, c.Refinements, c.Ranks, c.Axis);
    boxes.push_back(IndexBox());
    std::vector<ResolveReport> reports(boxes.size());
    std::atomic<Index> differences{ 0 };
    RunOnRanks(static_cast<int>(boxes.size()),
      [&](Ranks& ranks)
      {
        const LeafGrid mine(CartesianGrid(whole, boxes[ranks.Rank()], GhostLayers << c.Refinements),
          ranks.Rank() == 0 ? plan : MakePlan(c.Refinements, {}), ranks);
        const FractionField fractions = CopyToLocal(whole, field, mine.Finest);
        LabelArray labels = mine.Assign(fractions);
        reports[ranks.Rank()] = mine.Resolve(fractions, ranks, labels);
        ForCells(mine.Finest.Local(),
          [&](const Index3& p)
          { differences += labels[mine.Finest.Linear(p)] != expected[whole.Linear(p)]; });
      });
    EXPECT_EQ(differences, 0);
    for (const ResolveReport& r : reports)
    {
      EXPECT_EQ(r.FlippedCells, report.FlippedCells);
      EXPECT_EQ(r.Rounds, report.Rounds);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, LeafRanks,
  ::testing::Values(RankCase{ 1, 2, -1 }, RankCase{ 1, 3, 0 }, RankCase{ 1, 4, -1 },
    RankCase{ 1, 8, -1 }, RankCase{ 1, 8, 2 }, RankCase{ 2, 2, -1 }, RankCase{ 2, 3, 1 },
    RankCase{ 2, 8, -1 }));
