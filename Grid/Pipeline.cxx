#include "Pipeline.h"

#include "Labels/LeafLabels.h"
#include "Mesh/MeasureMaterials.h"
#include "Mesh/Quality.h"
#include "Smoothing/AttachCreases.h"
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
constexpr int SmallRounds = 40;          // for small fragments alone
constexpr double SmallTolerance = 5e-3;  // relative, of a small fragment
constexpr int Nudges = 6;
constexpr int MoreNudges = 4;           // where fragments were given up
constexpr double FinalTolerance = 1e-7; // relative

std::vector<double> Multiplied(std::vector<double> values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

/// Shifts the targets and smooths, then moves the surface points themselves by the little that is left. Small fragments, whose
/// surfaces the fractions place poorly and which resist, get more rounds and longer shifts.
void CorrectVolumes(const Improvement& what, Smoother& smoother, StageClock& clock)
{
  FragmentVolumes& volumes = what.Volumes;
  SmoothingStage stage = what.Ramp.back();
  stage.Sweeps = SweepsPerCorrection;
  const auto isSmall = [&volumes](const Attachment& a)
  { return volumes.IsSmall(a.Fragments[0]) || volumes.IsSmall(a.Fragments[1]); };
  for (int round = 0; round < CorrectionRounds && volumes.WorstError() > VolumeTolerance; ++round)
  {
    if (!smoother.Follow(volumes.FindShifts(what.Active), isSmall, stage))
    {
      break; // what is left the nudges make up for
    }
    volumes.Measure(what.Active);
    clock.Update(0.8 + 0.02 * round);
  }
  for (int round = 0; round < SmallRounds && volumes.WorstSmallError() > SmallTolerance; ++round)
  {
    smoother.Follow(volumes.FindShifts(what.Active), isSmall, stage);
    volumes.Measure(what.Active);
    clock.Update(0.92);
  }
  const int nudges = Nudges + (volumes.GiveUp(SmallTolerance) ? MoreNudges : 0);
  for (int nudge = 0; nudge < nudges && volumes.WorstError() > FinalTolerance; ++nudge)
  {
    smoother.Nudge(volumes.FindShifts(what.Active), what.Ramp.back());
    volumes.Measure(what.Active);
  }
}

} // namespace

void MeshStages::Resolve(LabelArray& labels)
{
  this->Clock.Start("Resolving labels", 0.05);
  const ResolveReport resolved =
    ResolveLabels(this->Grid, this->Fractions, labels, this->Parts, this->Run);
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
  MeasureMaterials(mesh, this->Run.Group(), this->Report);
}

namespace
{

void CountCarriers(
  const std::vector<CreaseKind>& kinds, const ActiveMesh& active, Ranks& ranks, MeshReport& report)
{
  std::vector<std::int64_t> counts(2, 0);
  active.ForOwned(
    [&](int point)
    {
      counts[0] += kinds[point] == CreaseKind::Edge;
      counts[1] += kinds[point] == CreaseKind::Corner;
    });
  ranks.Sum(counts);
  report.EdgePoints = counts[0];
  report.CornerPoints = counts[1];
}

} // namespace

std::vector<CreaseKind> MeshStages::AttachToCreases(const Interface& interface,
  const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets, ActiveMesh& active)
{
  if (this->Options.Edges == SharpEdges::Off || this->Options.IsoValue != 0.5 ||
    this->Options.Method != Smoothing::QuadricSurface)
  {
    return std::vector<CreaseKind>(active.X.size(), CreaseKind::None);
  }
  this->Clock.Start("Finding creases", 0.22);
  const Index firstTarget = targets.Count() - static_cast<Index>(interface.Points().size());
  const Creases creases(
    interface, this->Fractions, targets, firstTarget, this->Options.Edges, this->Parts, this->Run);
  const std::vector<CreaseKind> kinds =
    AttachCreases({ creases, interface, firstTarget }, facets, mesh, targets, active, this->Run);
  CountCarriers(kinds, active, this->Run.Group(), this->Report);
  return kinds;
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
  for (int level = static_cast<int>(levels.Asked.size()); level < plan.Refinements; ++level)
  {
    levels.Asked.push_back(levels.Grid->Families().Report(level).Wanted);
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
    levels.Coarse = std::make_unique<CoarseHexes>(*levels.Grid, labels, hexes, runtime);
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
    const ResolveReport resolved =
      ResolveLabels(grid, fractions, result.Labels, partition, runtime, result.Levels.Grid.get());
    report.FlippedCells = resolved.FlippedCells;
    report.ResolveRounds = resolved.Rounds;
    if (report.LevelRounds < FlipRounds &&
      AddFlippedFamilies(*result.Levels.Grid, resolved.CostlyFlips, plan, runtime.Group()))
    {
      continue;
    }
    result.Levels.Coarse = std::make_unique<CoarseHexes>(*result.Levels.Grid, result.Labels,
      CoarseHexes::Options{ options.MeshVoid, false, !options.StairStep }, runtime);
    if (!AddFamilies(result.Levels.Coarse->BadFamilies(), plan, runtime.Group()))
    {
      break;
    }
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
      if (IsCoarseElement(levels, id, mesh.Ids.ElementSlots))
      {
        countCoarse(CellOfCoarseElement(levels, id, mesh.Ids.ElementSlots));
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
    if (isOwned && IsCoarsePoint(levels, id, mesh.Ids.PointSlots))
    {
      countCoarse(CellOfCoarseCentre(levels, id, mesh.Ids.PointSlots));
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
  const Mesh& mesh, const std::vector<Index>& asked, Ranks& ranks, MeshReport& report)
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
    report.Levels.push_back({ 0, 0, 0, hexes[level] });
    if (level < refinements)
    {
      const OctantFamilies::LevelReport& families = mesh.Levels->Families().Report(level);
      MeshReport::Level& last = report.Levels.back();
      last.Families = families.Wanted + families.Balance + families.NonManifold;
      last.AddedForBalance = last.Families - families.Wanted;
      last.AddedForValidity = families.Wanted - asked[level];
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
  std::vector<std::int64_t> efforts{ 0, smoother.Visits() };
  what.Active.ForOwned([&](int) { ++efforts[0]; });
  runtime.Group().Sum(efforts);
  what.Report.SmoothedPoints = efforts[0];
  what.Report.Sweeps = smoother.Sweeps();
  what.Report.Visits = efforts[1];
}

void ReportVolumes(const CartesianGrid& grid, const FragmentVolumes& volumes, MeshReport& report)
{
  const double cellVolume = std::pow(grid.MeanWidth(), 3.0);
  report.TargetVolume = Multiplied(volumes.MaterialTargets(), cellVolume);
  report.MeshVolume = Multiplied(volumes.MaterialVolumes(), cellVolume);
  report.FragmentTargetVolume = Multiplied(volumes.FragmentTargets(), cellVolume);
  for (Index fragments : volumes.MaterialFragments())
  {
    report.Materials.push_back({ 0, fragments });
  }
}

} // namespace vfm
