#include "Phases/MakeLevels.h"

#include "Labels/LeafLabels.h"
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

} // namespace

void LabelLeaves(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, const Partition& partition, Runtime& runtime, MeshReport& report,
  LabelledGrid& result)
{
  LevelPlan plan = options.Levels;
  plan.Families.resize(plan.Refinements);
  const LabelArray ofCells = AssignMaterials(grid, fractions, options.IsoValue);
  for (;; ++report.LevelRounds)
  {
    MakeGrid(grid, plan, {}, runtime.Group(), result.Levels);
    result.Labels = AssignLeafMaterials(*result.Levels.Grid, fractions, ofCells, options.IsoValue);
    const ResolveReport resolved = ResolveLabels(
      grid, fractions, result.Labels, partition, runtime, result.Levels.Grid.get(), true);
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
