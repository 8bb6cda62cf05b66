/// Labels that meet the condition of flat seams keep grains and laminates.
#include "GluedChecks.h"
#include "Labels/LabelCondition.h"
#include "Labels/ResolveLabels.h"
#include "Labels/SeamBlocks.h"
#include "RandomDraw.h"
#include "RankFields.h"
#include "Sweep.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr std::array<bool, 3> AllAxes{ { true, true, true } };

struct Resolved
{
  LabelArray Labels;
  ResolveReport Report;
};

Resolved Resolve(const CartesianGrid& grid, const FractionField& field, bool keepsSeam)
{
  Runtime alone;
  Resolved result{ AssignMaterials(grid, field, 0.5), {} };
  result.Report = ResolveLabels(
    grid, field, result.Labels, Partition(grid, alone.Group()), alone, nullptr, keepsSeam);
  return result;
}

std::set<int> ListLabels(const CartesianGrid& grid, const LabelArray& labels)
{
  std::set<int> all;
  ForCells(grid.Domain(), [&](const Index3& cell) { all.insert(labels[grid.Linear(cell)]); });
  return all;
}

/// Returns the number of columns across seams that break the condition of flat seams.
Index CountBrokenColumns(const CartesianGrid& grid, const LabelArray& labels)
{
  std::set<std::pair<Index3, int>> broken; // cell above the seam, axis
  ForCells(NodesOf(grid.Domain()),
    [&](const Index3& node)
    {
      const std::array<int, 8> star = StarOfNode(grid, labels, grid.Linear(node));
      for (int a = 0; a < 3; ++a)
      {
        for (int c = 0; grid.IsOnFlatSeam(node, a) && c < 8; ++c)
        {
          if (BreaksSeam(star, c, a))
          {
            broken.emplace(grid.Canonical(CellOfStar(node, c | 1 << a)), a);
          }
        }
      }
    });
  return static_cast<Index>(broken.size());
}

/// Returns the sum of the fractions that cells lose from the first labels to others.
double FindLoss(const CartesianGrid& grid, const FractionField& field, const LabelArray& first,
  const LabelArray& labels)
{
  double loss = 0.0;
  ForCells(grid.Domain(),
    [&](const Index3& cell)
    {
      const Index at = grid.Linear(cell);
      loss += field.Fraction(at, first[at]) - field.Fraction(at, labels[at]);
    });
  return loss;
}

/// Returns the number of nodes of the domain whose stars do not pass.
Index CountViolatedNodes(const CartesianGrid& grid, const LabelArray& labels)
{
  Index count = 0;
  ForCells(NodesOf(grid.Domain()),
    [&](const Index3& node)
    {
      const std::array<int, 8> star = StarOfNode(grid, labels, grid.Linear(node));
      count += CountViolations(star) + CountSeamViolations(star, grid.FlatSeams(node)) > 0;
    });
  return count;
}

/// Returns two layers, the lower one from height(x, y) to half of the domain, which has n cells
/// along each axis.
FractionField MakeLaminate(
  const CartesianGrid& grid, const std::function<double(double, double)>& height)
{
  FractionField field(grid, 2);
  ForCells(grid.Local(),
    [&](const Index3& cell)
    {
      const Index3 own = grid.Canonical(cell);
      const auto n = static_cast<double>(grid.Domain().Size(2));
      const auto at = [&](int a) { return static_cast<double>(own[a] - grid.Domain().Lower[a]); };
      const double h = height(at(0) + 0.5, at(1) + 0.5);
      // the overlap of the cell with the lower layer and its copy one period higher
      double lower = 0.0;
      for (const double shift : { 0.0, n })
      {
        lower += std::max(0.0, std::min(at(2) + 1.0, n / 2.0 + shift) - std::max(at(2), h + shift));
      }
      std::vector<FractionField::Part> parts;
      if (lower > 0.0)
      {
        parts.push_back({ 1, lower });
      }
      if (lower < 1.0)
      {
        parts.push_back({ 2, 1.0 - lower });
      }
      field.SetParts(grid.Linear(cell), parts);
    });
  return field;
}

} // namespace

TEST(FlatSeam, BlocksAreGluedAlongAxes)
{
  const CartesianGrid grid = MakePeriodicGrid({ { 5, 5, 5 } }, AllAxes);
  const Index3 corner = grid.Domain().Lower;
  LabelArray labels(grid, 1);
  EXPECT_EQ(
    BlockOfCell(grid, { { corner[0] + 2, corner[1] + 2, corner[2] + 2 } }).NumberOfCells(), 1);
  EXPECT_EQ(
    BlockOfCell(grid, { { corner[0] + 2, corner[1] + 4, corner[2] + 2 } }).NumberOfCells(), 2);
  const IndexBox block = BlockOfCell(grid, corner);
  EXPECT_EQ(block.NumberOfCells(), 8);
  EXPECT_EQ(BlockOfCell(grid, block.Lower), block);
  EXPECT_EQ(FindGluedAxes(grid, labels, block), 7);
  labels.Set(grid.Linear(corner), 2);
  EXPECT_EQ(FindGluedAxes(grid, labels, block), 0);
  labels.Set(grid.Linear({ { corner[0], corner[1] - 1, corner[2] } }), 2);
  EXPECT_EQ(FindGluedAxes(grid, labels, block), 2);
  EXPECT_EQ(PartOfBlock(block, 2, corner).NumberOfCells(), 2);
}

TEST(FlatSeam, PolycrystalNeedsFewFlips)
{
  Index flips = 0, needed = 0, others = 0;
  double cost = 0.0;
  for (unsigned seed : ListSeeds(6))
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Index n = 12 + seed % 2;
    const CartesianGrid grid = MakePeriodicGrid({ { n, n, n } }, AllAxes);
    const FractionField field = MakePeriodicPolycrystal(grid, seed);
    const LabelArray first = AssignMaterials(grid, field, 0.5);
    const Resolved flat = Resolve(grid, field, true);
    EXPECT_EQ(CountViolatedNodes(grid, flat.Labels), 0);
    flips += flat.Report.FlippedCells;
    cost += FindLoss(grid, field, first, flat.Labels);
    // Each broken column needs a flip; at other places, there are about as many as without seams.
    needed += CountBrokenColumns(grid, first);
    others += Resolve(grid, field, false).Report.FlippedCells;
    EXPECT_LE(flips, needed + 2 * others);
  }
  if (IsWholeSweep())
  {
    EXPECT_LT(static_cast<double>(flips - needed), 1.15 * static_cast<double>(others));
    EXPECT_LT(cost, 0.42 * static_cast<double>(flips));
  }
}

TEST(FlatSeam, PolycrystalKeepsGrains)
{
  const CartesianGrid grid = MakePeriodicGrid({ { 13, 13, 13 } }, AllAxes);
  const FractionField field = MakePeriodicPolycrystal(grid, 1);
  Runtime alone;
  MeshReport report;
  const Mesh mesh = MakeHexMesh(grid, field, MeshOptions(), alone, report);
  EXPECT_EQ(report.NumberOfFragments, 20);
  EXPECT_EQ(FindGluedProblem(grid, mesh, true, report.NumberOfFragments), "");
  EXPECT_TRUE(IsPositiveEverywhere(mesh));
  for (int m = 1; m <= field.NumberOfMaterials(); ++m)
  {
    EXPECT_NEAR(report.MeshVolume[m] / report.TargetVolume[m], 1.0, 2e-5) << m;
  }
}

TEST(FlatSeam, SmallGrainsKeepACell)
{
  for (unsigned seed : ListSeeds(6))
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const CartesianGrid grid = MakePeriodicGrid({ { 8, 8, 8 } }, AllAxes);
    const FractionField field = MakePeriodicPolycrystal(grid, seed, 100);
    EXPECT_EQ(ListLabels(grid, Resolve(grid, field, true).Labels),
      ListLabels(grid, AssignMaterials(grid, field, 0.5)));
  }
}

TEST(FlatSeam, RanksGiveTheSameLabels)
{
  const auto resolve = [](const CartesianGrid& part, const Partition& partition, Runtime& runtime,
                         FractionField& field)
  {
    LabelArray labels = AssignMaterials(part, field, 0.5);
    ResolveLabels(part, field, labels, partition, runtime, nullptr, true);
    ForCells(part.Local(),
      [&](const Index3& p) { field.SetLabel(part.Linear(p), labels[part.Linear(p)]); });
  };
  for (unsigned seed : ListSeeds(2))
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const CartesianGrid grid = MakePeriodicGrid({ { 12, 12, 12 } }, AllAxes);
    EXPECT_EQ(FindRankProblem(grid, MakePeriodicPolycrystal(grid, seed), resolve), "");
    const CartesianGrid small = MakePeriodicGrid({ { 8, 7, 6 } }, AllAxes);
    EXPECT_EQ(FindRankProblem(small, MakeRandomPeriodic(small, 3, 0, seed + 4), resolve), "");
  }
}

TEST(FlatSeam, LaminateOnSeamIsKept)
{
  const CartesianGrid grid = MakePeriodicGrid({ { 8, 8, 8 } }, AllAxes);
  const auto wave = [](double x, double y)
  { return 0.4 * std::sin(x * std::acos(-1.0) / 4.0) * std::cos(y * std::acos(-1.0) / 4.0); };
  EXPECT_EQ(Resolve(grid, MakeLaminate(grid, wave), true).Report.FlippedCells, 0);
  // An interface that leaves the seam cannot be on it anywhere.
  const auto slope = [](double x, double) { return 0.5 * std::fabs(x - 4.0) - 1.0; };
  const FractionField tilted = MakeLaminate(grid, slope);
  ASSERT_GT(CountBrokenColumns(grid, AssignMaterials(grid, tilted, 0.5)), 0);
  const Resolved resolved = Resolve(grid, tilted, true);
  EXPECT_GT(resolved.Report.FlippedCells, 0);
  EXPECT_EQ(CountViolatedNodes(grid, resolved.Labels), 0);
}
