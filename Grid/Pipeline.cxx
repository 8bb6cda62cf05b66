#include "Pipeline.h"

#include "Labels/LeafLabels.h"
#include "Mesh/Quality.h"
#include "Tet/TetTopology.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr int FlipRounds =
  4; // in which cells between levels are refined where labels had to be changed
constexpr int CorrectionRounds = 6;
constexpr int SweepsPerCorrection = 4;
constexpr double VolumeTolerance = 2e-4; // relative, of the rounds with smoothing
constexpr int Nudges = 4;
constexpr double FinalTolerance = 1e-7; // relative

std::vector<double> Multiplied(std::vector<double> values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

/// Shifts the targets and smooths, then moves the surface points themselves by the little that is left.
void CorrectVolumes(const Improvement& what, Smoother& smoother, StageClock& clock)
{
  FragmentVolumes& volumes = what.Volumes;
  SmoothingStage stage = what.Ramp.back();
  stage.Sweeps = SweepsPerCorrection;
  for (int round = 0; round < CorrectionRounds && volumes.WorstError() > VolumeTolerance; ++round)
  {
    smoother.Shift(volumes.FindShifts(what.Active));
    smoother.RunStage(stage, [&](double) { clock.Update(0.8 + 0.02 * round); });
    volumes.Measure(what.Active);
  }
  for (int nudge = 0; nudge < Nudges && volumes.WorstError() > FinalTolerance; ++nudge)
  {
    smoother.Nudge(volumes.FindShifts(what.Active), what.Ramp.back());
    volumes.Measure(what.Active);
  }
}

} // namespace

void MeshStages::Resolve(LabelArray& labels)
{
  this->Clock.Start("Resolving labels", 0.05);
  const ResolveReport resolved = ResolveLabels(this->Grid, this->Fractions, labels, this->Parts);
  this->Report.FlippedCells = resolved.FlippedCells;
  this->Report.ResolveRounds = resolved.Rounds;
}

void MeshStages::MeasureQuality(Mesh& mesh)
{
  if (this->Options.ComputeQuality)
  {
    this->Clock.Start("Measuring quality", 0.95);
    ComputeQuality(mesh, this->Run, this->Report);
  }
}

void CheckOptions(const MeshOptions& options)
{
  if (!(options.IsoValue > 0.0 && options.IsoValue < 1.0))
  {
    throw InputError("IsoValue is " + std::to_string(options.IsoValue) +
      ": it must lie between 0 and 1, both excluded.");
  }
  if (!(options.TargetScaledJacobian >= 0.0 && options.TargetScaledJacobian < 1.0))
  {
    throw InputError("TargetScaledJacobian is " + std::to_string(options.TargetScaledJacobian) +
      ": it must lie in [0, 1), 0 chooses it automatically.");
  }
  if (options.Levels.Refinements < 0 || options.Levels.FineLayers < 2)
  {
    throw InputError("FineLayers is " + std::to_string(options.Levels.FineLayers) +
      " and there are " + std::to_string(options.Levels.Refinements) +
      " refinements: at least 2 layers and 0 refinements are needed.");
  }
}

LevelHexes MakeLevels(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& interfaces, const MeshOptions& options, Runtime& runtime, bool asCubes)
{
  LevelHexes levels;
  levels.Grid =
    std::make_shared<const RefinedGrid>(grid, options.Levels, interfaces, runtime.Group());
  levels.Coarse = std::make_unique<CoarseHexes>(
    *levels.Grid, labels, CoarseHexes::Options{ options.MeshVoid, asCubes, true }, runtime);
  if (!levels.Grid->IsUniform())
  {
    ReleaseFreeMemory();
  }
  return levels;
}

namespace
{

/// Adds to a plan what has no valid start; whether any rank had some.
bool AddBadFamilies(const SplitNodes& splits, LevelPlan& plan, Ranks& ranks)
{
  bool found = false;
  for (std::size_t level = 0; level < splits.BadFamilies().size(); ++level)
  {
    const std::vector<Index>& bad = splits.BadFamilies()[level];
    plan.Families[level].insert(plan.Families[level].end(), bad.begin(), bad.end());
    found = found || !bad.empty();
  }
  return ranks.Any(found);
}

/// Adds transition cells whose label had to be changed at a price; whether any rank had some. In finer cells it costs less.
bool AddFlippedFamilies(
  const RefinedGrid& levels, const std::vector<Index3>& flips, LevelPlan& plan, Ranks& ranks)
{
  bool found = false;
  for (const Index3& cell : flips)
  {
    const OctreeKeys::LevelIndex leaf = levels.LeafOf(cell);
    if (levels.Families().IsTouched(leaf.Level, leaf.At))
    {
      plan.Families[leaf.Level].push_back(
        levels.Lattice().FamilyKey(leaf.Level, ParentOfCell(leaf.At)));
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
  for (;;)
  {
    result.Levels.Coarse.reset();
    result.Levels.Grid =
      std::make_shared<const RefinedGrid>(grid, plan, std::vector<Index>(), runtime.Group());
    for (int level = static_cast<int>(result.AskedFamilies.size()); level < plan.Refinements;
         ++level)
    {
      result.AskedFamilies.push_back(result.Levels.Grid->Families().Report(level).Wanted);
    }
    result.Labels = AssignLeafMaterials(*result.Levels.Grid, fractions, ofCells, options.IsoValue);
    const ResolveReport resolved =
      ResolveLabels(grid, fractions, result.Labels, partition, result.Levels.Grid.get());
    report.FlippedCells = resolved.FlippedCells;
    report.ResolveRounds = resolved.Rounds;
    if (report.LevelRounds < FlipRounds &&
      AddFlippedFamilies(*result.Levels.Grid, resolved.CostlyFlips, plan, runtime.Group()))
    {
      ++report.LevelRounds;
      continue;
    }
    result.Levels.Coarse = std::make_unique<CoarseHexes>(*result.Levels.Grid, result.Labels,
      CoarseHexes::Options{ options.MeshVoid, false, !options.StairStep }, runtime);
    if (options.StairStep || !AddBadFamilies(result.Levels.Coarse->Splits(), plan, runtime.Group()))
    {
      break;
    }
    ++report.LevelRounds;
  }
  result.Mixed = FindMixedNodes(grid, result.Labels);
  ReleaseFreeMemory();
}

namespace
{

/// Whole cells of each level, then transition hexes. Tets: of those whose centres are points.
std::vector<std::int64_t> CountHexes(const Mesh& mesh)
{
  const RefinedGrid& levels = *mesh.Levels;
  const int refinements = levels.NumberOfRefinements();
  std::vector<std::int64_t> hexes(refinements + 2, 0);
  const auto countCoarse = [&](const OctreeKeys::LevelIndex& cell)
  {
    const bool isWhole = !levels.Families().IsTouched(cell.Level, cell.At);
    ++hexes[isWhole ? cell.Level : refinements + 1];
  };
  if (mesh.Corners == 8)
  {
    for (Index id : mesh.ElementIds)
    {
      if (levels.IsCoarseElement(id, mesh.Ids.ElementSlots))
      {
        countCoarse(levels.CellOfCoarseElement(id, mesh.Ids.ElementSlots));
      }
      else
      {
        ++hexes[refinements];
      }
    }
    return hexes;
  }
  for (Index id : mesh.PointIds)
  {
    if (!IsCentre(mesh, id))
    {
      continue;
    }
    const bool isOwned = levels.Finest().Owned().Contains(CellOfCentre(levels.Finest(), mesh, id));
    if (isOwned && levels.IsCoarsePoint(id, mesh.Ids.PointSlots))
    {
      countCoarse(levels.CellOfCoarseCentre(id, mesh.Ids.PointSlots));
    }
    else
    {
      hexes[refinements] += isOwned;
    }
  }
  return hexes;
}

} // namespace

void ReportLevels(
  const Mesh& mesh, Ranks& ranks, MeshReport& report, const std::vector<Index>& asked)
{
  if (mesh.Levels->IsUniform())
  {
    return;
  }
  const int refinements = mesh.Levels->NumberOfRefinements();
  std::vector<std::int64_t> hexes = CountHexes(mesh);
  ranks.Sum(hexes);
  for (int level = 0; level <= refinements; ++level)
  {
    report.Levels.push_back({ 0, 0, hexes[level] });
    if (level < refinements)
    {
      const OctantFamilies::LevelReport& families = mesh.Levels->Families().Report(level);
      const Index wanted = asked.empty() ? families.Wanted : asked[level];
      report.Levels.back().Families = families.Wanted + families.Balance + families.NonManifold;
      report.Levels.back().Added = report.Levels.back().Families - wanted;
    }
  }
  report.TransitionCells = hexes[refinements + 1];
}

void Improve(const Improvement& what, StageClock& clock, Runtime& runtime)
{
  clock.Start("Smoothing", 0.25);
  Smoother smoother(what.Active, &what.Targets, what.Energy, runtime);
  double done = 0.25;
  for (const SmoothingStage& stage : what.Ramp)
  {
    const double share = 0.01 * stage.Sweeps;
    int sweep = 0;
    smoother.RunStage(stage,
      [&](double fraction)
      {
        clock.Update(done + share * fraction);
        if (what.AfterSweep)
        {
          what.AfterSweep(smoother, stage, sweep++);
        }
      });
    done += share;
  }
  if (what.AfterRamp)
  {
    what.AfterRamp();
  }
  what.Volumes.Measure(what.Active);
  if (what.ConserveVolume)
  {
    clock.Start("Correcting volumes", 0.8);
    CorrectVolumes(what, smoother, clock);
  }
}

void ReportVolumes(const CartesianGrid& grid, const FragmentVolumes& volumes, MeshReport& report)
{
  const double cellVolume = std::pow(grid.MeanWidth(), 3.0);
  report.TargetVolume = Multiplied(volumes.MaterialTargets(), cellVolume);
  report.MeshVolume = Multiplied(volumes.MaterialVolumes(), cellVolume);
  report.FragmentTargetVolume = Multiplied(volumes.FragmentTargets(), cellVolume);
}

} // namespace vfm
