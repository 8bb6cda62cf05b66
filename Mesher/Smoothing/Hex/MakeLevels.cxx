#include "Smoothing/Hex/MakeLevels.h"

#include "Elements/ResolveCells.h"
#include "Labels/LeafLabels.h"
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

/// Gives leaves of the finest level the labels of thin parts; larger leaves keep their labels.
/// Returns these leaves.
/// @param thin  cells of thin parts; thinLabels: their labels
std::vector<ThinCell> LabelThinLeaves(const RefinedGrid& levels, const std::vector<ThinCell>& thin,
  const LabelArray& thinLabels, LabelArray& labels)
{
  const CartesianGrid& grid = levels.Finest();
  const LabelUnits units(grid, &levels);
  std::vector<ThinCell> leaves;
  for (const ThinCell& cell : thin)
  {
    const IndexBox cells = units.CellsOf(units.UnitOf(grid.Position(cell.Cell)));
    if (cells.NumberOfCells() == 1)
    {
      FillLabels(grid, cells, thinLabels[cell.Cell], labels);
      leaves.push_back(cell);
    }
  }
  return leaves;
}

/// Makes levels and labels of leaves where interfaces may cross levels. Refines leaves until a
/// valid mesh starts everywhere.
void LabelLeaves(const MeshCells& cells, MeshRun& run, LabelledGrid& result)
{
  const CartesianGrid& grid = cells.Grid;
  const MeshOptions& options = cells.Options;
  LevelPlan plan = options.Levels;
  plan.Families.resize(plan.Refinements);
  const LabelArray ofCells = AssignMaterials(grid, cells.Fractions, options.IsoValue);
  LabelArray thinLabels = KeepsThinParts(options) ? ofCells : LabelArray();
  const std::vector<ThinCell> thin = LabelThinCells(cells, run, thinLabels);
  for (;; ++run.Report.LevelRounds)
  {
    MakeGrid(grid, plan, {}, run.Group(), result.Levels);
    const RefinedGrid& levels = *result.Levels.Grid;
    result.Labels = AssignLeafMaterials(levels, cells.Fractions, ofCells, options.IsoValue);
    const std::vector<ThinCell> leaves = LabelThinLeaves(levels, thin, thinLabels, result.Labels);
    ReportThinCells(cells, leaves, run);
    result.Thin = CellsOf(leaves);
    const ResolveReport resolved =
      ResolveLabels(grid, WithClaims(cells.Fractions, thinLabels, leaves).Field(), result.Labels,
        run.Parts, run.TheRuntime, &levels, true);
    ReportFlips(resolved, run.Report);
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
