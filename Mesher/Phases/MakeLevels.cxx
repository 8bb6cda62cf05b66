#include "Phases/MakeLevels.h"

#include "Labels/LeafLabels.h"
#include "Ranks/Agreement.h"
#include "Smoothing/Hex/TransitionSmoothing.h"

namespace vfm
{
namespace
{

// Number of rounds that refine transition cells whose labels had to be changed.
constexpr int FlipRounds = 4;

} // namespace

void ReportFlips(const ResolveReport& resolved, MeshReport& report)
{
  report.FlippedCells = resolved.FlippedCells;
  report.LostCells = resolved.LostCells;
  report.GainedCells = resolved.GainedCells;
  report.ResolveRounds = resolved.Rounds;
}

void ReportThinCells(
  const CartesianGrid& grid, const std::vector<ThinCell>& thin, Ranks& ranks, MeshReport& report)
{
  const auto owned = std::count_if(thin.begin(), thin.end(),
    [&](const ThinCell& cell) { return grid.Owned().Contains(grid.Position(cell.Cell)); });
  report.ThinPartCells = SumOverRanks(static_cast<Index>(owned), ranks);
}

std::unique_ptr<CoarseHexes> MakeCoarseHexes(const RefinedGrid& grid, const LabelArray& labels,
  const CoarseHexes::Options& options, Runtime& runtime)
{
  if (grid.IsUniform())
  {
    return std::make_unique<CoarseHexes>(grid, labels, options);
  }
  RefinedMesh refined = MakeRefinedMesh(grid.Families(), CoarseHexes::RegionOf(grid), false);
  const TransitionReport report =
    SmoothTransitions(grid.Lattice(), refined, runtime, true, options.AsCubes);
  return std::make_unique<CoarseHexes>(grid, labels, options, std::move(refined), report.BadCells);
}

bool AddFamilies(const std::vector<std::vector<Index>>& families, LevelPlan& plan, Ranks& ranks)
{
  bool found = false;
  for (std::size_t level = 0; level < families.size(); ++level)
  {
    std::vector<Index>& own = plan.Families[level];
    own.insert(own.end(), families[level].begin(), families[level].end());
    found = found || !families[level].empty();
  }
  return ranks.Any(found);
}

namespace
{

void MakeGrid(const CartesianGrid& grid, const LevelPlan& plan,
  const std::vector<Index>& interfaces, Ranks& ranks, LevelHexes& levels)
{
  levels.Coarse.reset();
  levels.Grid = std::make_shared<const RefinedGrid>(grid, plan, interfaces, ranks);
  for (int level = static_cast<int>(levels.RequestedFamilies.size()); level < plan.Refinements;
       ++level)
  {
    levels.RequestedFamilies.push_back(levels.Grid->Families().Report(level).Requested);
  }
}

} // namespace

void MakeLevels(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& interfaces, const CoarseHexes::Options& hexes, LevelPlan& plan,
  Runtime& runtime, MeshReport& report, LevelHexes& levels)
{
  plan.Families.resize(plan.Refinements);
  for (;; ++report.LevelRounds)
  {
    MakeGrid(grid, plan, interfaces, runtime.Group(), levels);
    levels.Coarse = MakeCoarseHexes(*levels.Grid, labels, hexes, runtime);
    if (levels.Grid->IsUniform())
    {
      return;
    }
    ReleaseFreeMemory();
    if (!AddFamilies(levels.Coarse->BadFamilies(), plan, runtime.Group()))
    {
      return;
    }
  }
}

namespace
{

/// Adds the families of transition cells whose label was changed at a high cost; in finer cells the
/// cost is lower. Returns whether any rank added some.
bool AddFlippedFamilies(
  const RefinedGrid& levels, const std::vector<Index3>& flips, LevelPlan& plan, Ranks& ranks)
{
  bool found = false;
  for (const Index3& cell : flips)
  {
    const OctreeKeys::LevelIndex leaf = levels.LeafOf(cell);
    if (levels.Families().IsTouched(leaf.Level, leaf.At))
    {
      plan.Families[leaf.Level].push_back(levels.Lattice().FamilyKeyOf(leaf));
      found = true;
    }
  }
  return ranks.Any(found);
}

/// Cells of thin parts with the labels and the fractions that decide there.
struct ThinLeaves
{
  LabelArray Labels;           // of all cells
  std::vector<ThinCell> Cells; // ascending
};

/// Gives leaves of the finest level the labels of thin parts; larger leaves are filled by one
/// material for the most part or keep their label. Returns these leaves.
std::vector<ThinCell> LabelThinLeaves(
  const RefinedGrid& levels, const ThinLeaves& thin, LabelArray& labels)
{
  const CartesianGrid& grid = levels.Finest();
  const LabelUnits units(grid, &levels);
  std::vector<ThinCell> leaves;
  for (const ThinCell& cell : thin.Cells)
  {
    const IndexBox cells = units.CellsOf(units.UnitOf(grid.Position(cell.Cell)));
    if (cells.NumberOfCells() == 1)
    {
      FillLabels(grid, cells, thin.Labels[cell.Cell], labels);
      leaves.push_back(cell);
    }
  }
  return leaves;
}

} // namespace

void LabelLeaves(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, const Partition& partition, Runtime& runtime, MeshReport& report,
  LabelledGrid& result)
{
  LevelPlan plan = options.Levels;
  plan.Families.resize(plan.Refinements);
  const LabelArray ofCells = AssignMaterials(grid, fractions, options.IsoValue);
  ThinLeaves thin;
  if (KeepsThinParts(options))
  {
    thin.Labels = ofCells;
    thin.Cells =
      LabelThinParts(grid, fractions, options.LeastThickness, partition, runtime, thin.Labels);
  }
  for (;; ++report.LevelRounds)
  {
    MakeGrid(grid, plan, {}, runtime.Group(), result.Levels);
    result.Labels = AssignLeafMaterials(*result.Levels.Grid, fractions, ofCells, options.IsoValue);
    const std::vector<ThinCell> leaves = LabelThinLeaves(*result.Levels.Grid, thin, result.Labels);
    ReportThinCells(grid, leaves, runtime.Group(), report);
    const ResolveReport resolved =
      ResolveLabels(grid, WithClaims(fractions, thin.Labels, leaves).Field(), result.Labels,
        partition, runtime, result.Levels.Grid.get(), true);
    ReportFlips(resolved, report);
    if (report.LevelRounds < FlipRounds &&
      AddFlippedFamilies(*result.Levels.Grid, resolved.CostlyFlips, plan, runtime.Group()))
    {
      continue;
    }
    result.Mixed = FindMixedNodes(grid, result.Labels);
    result.Narrow = FindBarrier(options, *result.Levels.Grid, result.Labels, result.Mixed, runtime);
    result.Levels.Coarse = MakeCoarseHexes(*result.Levels.Grid, result.Labels,
      { options.MeshVoid, false, !options.StairStep, &result.Narrow }, runtime);
    if (!AddFamilies(result.Levels.Coarse->BadFamilies(), plan, runtime.Group()))
    {
      break;
    }
  }
  ReleaseFreeMemory();
}

} // namespace vfm
