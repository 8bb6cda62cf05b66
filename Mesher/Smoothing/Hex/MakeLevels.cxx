#include "Smoothing/Hex/MakeLevels.h"

#include "Elements/ResolveCells.h"
#include "Smoothing/Hex/TransitionSmoothing.h"

namespace vfm
{
namespace
{

// Number of rounds that refine transition cells whose labels had to be changed.
constexpr int FlipRounds = 4;

} // namespace

std::unique_ptr<CoarseHexes> MakeCoarseHexes(const RefinedGrid& grid, const LabelArray& labels,
  const CoarseHexes::Options& options, Runtime& runtime)
{
  if (grid.IsUniform())
  {
    return std::make_unique<CoarseHexes>(grid, labels, options);
  }
  RefinedMesh refined = MakeRefinedMesh(grid.Families(), CoarseHexes::RegionOf(grid), false);
  const TransitionReport report = SmoothTransitions(grid.Lattice(), refined, runtime);
  return std::make_unique<CoarseHexes>(grid, labels, options, std::move(refined), report.BadCells);
}

namespace
{

/// Adds families to a plan because no valid mesh starts there. Returns whether any rank added
/// families. Collective.
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

/// Makes levels and labels of leaves where interfaces may cross levels. Refines leaves until a
/// valid mesh starts everywhere.
void LabelLeaves(const MeshCells& cells, MeshRun& run, LabelledGrid& result)
{
  const CartesianGrid& grid = cells.Grid;
  const MeshOptions& options = cells.Options;
  LevelPlan plan = options.Levels;
  plan.Families.resize(plan.Refinements);
  const CellLabels ofCells = LabelCellsOfLeaves(cells, run);
  for (;; ++run.Report.LevelRounds)
  {
    MakeGrid(grid, plan, {}, run.Group(), result.Levels);
    const RefinedGrid& levels = *result.Levels.Grid;
    ResolvedLeaves resolved = ResolveLeaves(cells, levels, ofCells, true, run);
    result.Labels = std::move(resolved.Labels);
    result.Thin = std::move(resolved.Thin);
    if (run.Report.LevelRounds < FlipRounds &&
      AddFlippedFamilies(levels, resolved.CostlyFlips, plan, run.Group()))
    {
      continue;
    }
    result.Mixed = FindMixedNodes(grid, result.Labels);
    result.Narrow = FindBarrier(options, levels, result.Labels, result.Mixed, run.TheRuntime);
    result.Levels.Coarse = MakeCoarseHexes(levels, result.Labels,
      { options.MeshVoid, !options.StairStep, &result.Narrow }, run.TheRuntime);
    if (!AddFamilies(result.Levels.Coarse->BadFamilies(), plan, run.Group()))
    {
      break;
    }
  }
  ReleaseFreeMemory();
}

} // namespace

void LabelCells(const MeshCells& cells, MeshRun& run, LabelledGrid& result)
{
  const MeshOptions& options = cells.Options;
  if (InterfacesCrossLevels(options))
  {
    run.Clock.Start("Assigning materials", 0.0);
    LabelLeaves(cells, run, result);
    return;
  }
  ResolvedCells resolved = ResolveCells(cells, true, run);
  result.Labels = std::move(resolved.Labels);
  result.Thin = std::move(resolved.Thin);
  run.Clock.Start("Making hexahedra", 0.1);
  result.Mixed = FindMixedNodes(cells.Grid, result.Labels);
  LevelPlan plan = options.Levels;
  MakeLevels(cells.Grid, result.Labels, result.Mixed, { options.MeshVoid, true }, plan,
    run.TheRuntime, run.Report, result.Levels);
  result.Narrow =
    FindBarrier(options, *result.Levels.Grid, result.Labels, result.Mixed, run.TheRuntime);
}

} // namespace vfm
