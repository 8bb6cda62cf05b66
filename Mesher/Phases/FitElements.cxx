#include "Phases/FitElements.h"

#include "Interface/SurfaceTargets.h"
#include "Smoothing/Attach.h"
#include "Smoothing/AttachFeatures.h"
#include "Smoothing/EaseTargets.h"
#include "Smoothing/EdgePulls.h"
#include "Volumes/VolumeCorrection.h"

#include <optional>

namespace vfm
{
namespace
{

// Rounds of EndIntersections after which volumes are corrected, and points move again. Further
// rounds only put points back.
constexpr int CorrectedRounds = 4, MovingRounds = 30;
// Rounds in which edges give way to quality after volumes were corrected, and volumes again.
constexpr int EasedRounds = 5;

/// Attaches the active points to the interfaces.
/// @param[out] kinds  of the active points
/// @param[out] interfaces  must live as long as the targets
SurfaceTargets FindTargets(const MeshCells& cells, const Draft& draft, ElementMethod& method,
  MeshRun& run, ActiveMesh& active, std::vector<FeatureKind>& kinds,
  std::unique_ptr<LevelInterfaces>& interfaces)
{
  interfaces = method.FindInterfaces(cells, draft, run);
  run.Clock.Start("Fitting surfaces", 0.2);
  // Before the targets, which would add to the peak of memory.
  method.Attach(*interfaces, draft, run);
  run.Clock.Update(0.205);
  const SurfaceTargets::Kind kind = KindOfTargets(cells.Options);
  SurfaceTargets targets(interfaces->All(), kind, run.TheRuntime);
  const std::vector<Facet> features = method.FeatureFacets(cells, draft);
  kinds = AttachToFeatures(cells, interfaces->All(), features.empty() ? draft.Facets : features,
    draft.Elements, run, targets, active);
  if (kind == SurfaceTargets::Kind::Quadrics)
  {
    interfaces.reset(); // only facets need them
  }
  SetFacets(draft.Facets, run.TheRuntime, active);
  return targets;
}

/// Runs the ramp of smoothing, and shifts the targets in its last stage if elements do not change.
void RunRamp(const SmoothingRamp& ramp, bool shifts, ElementMethod& method, StageClock& clock,
  Smoother& smoother, VolumeCorrection& correction)
{
  double done = 0.25;
  for (const SmoothingStage& stage : ramp)
  {
    const double share = 0.01 * stage.Sweeps;
    int sweep = 0;
    smoother.RunStage(stage,
      [&](double fraction)
      {
        clock.Update(done + share * fraction);
        method.AfterSweep(stage, sweep, smoother);
        ++sweep;
        if (shifts && &stage == &ramp.back())
        {
          correction.ShiftAfterSweep(sweep);
        }
      });
    done += share;
  }
}

/// Corrects the volumes and ends intersections, in turns.
void CorrectMesh(bool conserves, const SmoothingStage& last, StageClock& clock, Smoother& smoother,
  VolumeCorrection& correction)
{
  const auto correct = [&]
  {
    if (conserves)
    {
      clock.Start("Correcting volumes", 0.8);
      correction.Run();
    }
  };
  correct();
  for (int round = 0; smoother.EndIntersections(last, round < MovingRounds); ++round)
  {
    correction.MeasureAll();
    if (round < CorrectedRounds)
    {
      correct();
    }
  }
  correction.MeasureBulges();
}

/// The same, with targets of given surfaces that give way before and after.
void CorrectEasedMesh(bool conserves, const SmoothingStage& last, StageClock& clock,
  Smoother& smoother, VolumeCorrection& correction)
{
  bool isEased = EaseTargets(last, smoother);
  for (int round = 0; round == 0 || isEased; ++round)
  {
    if (isEased)
    {
      correction.MeasureAll();
    }
    CorrectMesh(conserves, last, clock, smoother, correction);
    isEased = round < EasedRounds && EaseTargets(last, smoother);
  }
}

/// Smooths the active mesh. If the options request it, moves the interfaces until the relative
/// errors of the volumes are at most 1e-7 or the rounds are used up.
/// @param local  null: there are no thin cells
void MovePoints(const MeshCells& cells, const SurfaceTargets& targets, const LocalVolumes* local,
  ElementMethod& method, MeshRun& run, Draft& draft, ActiveMesh& active)
{
  const SmoothingRamp ramp = method.Ramp(cells);
  const bool conserves = ConservesVolume(cells.Options);
  VolumeCorrection::MeasureBulgesFunction bulgesOf;
  if (HasCurvedEdges(cells.Options))
  {
    bulgesOf = [&]
    {
      return MeasureBulges(
        FindEdgePulls(draft.Facets, draft.Elements, targets, active, run.TheRuntime),
        draft.Elements, active, draft.Volumes.Share(), run.TheRuntime);
    };
  }
  run.Clock.Start("Smoothing", 0.25);
  Smoother smoother(active, &targets, method.Energy(), run.TheRuntime);
  VolumeCorrection correction(
    draft.Volumes, smoother, run.Clock, ramp.back(), draft.IsThin, local, bulgesOf);
  RunRamp(ramp, conserves && !method.ChangesElements(), method, run.Clock, smoother, correction);
  if (method.ChangesElements())
  {
    method.AfterRamp(cells, run, draft);
    correction.MeasureAll();
  }
  else
  {
    correction.Measure();
  }
  const SmoothingStage& last = ramp.back();
  if (cells.Surfaces)
  {
    CorrectEasedMesh(conserves, last, run.Clock, smoother, correction);
  }
  else
  {
    CorrectMesh(conserves, last, run.Clock, smoother, correction);
  }
  smoother.ReportMoves(run.Report);
}

/// Moves the active points to the interfaces. The targets and the interfaces are freed at the end.
void MoveToTargets(
  const MeshCells& cells, ElementMethod& method, MeshRun& run, Draft& draft, ActiveMesh& active)
{
  std::vector<FeatureKind> kinds;
  std::unique_ptr<LevelInterfaces> interfaces;
  const SurfaceTargets targets = FindTargets(cells, draft, method, run, active, kinds, interfaces);
  std::optional<LocalVolumes> local;
  // Tets would crumple; elements of a refined mesh do not fill whole cells of the finest grid.
  if (!draft.IsThin.empty() && active.HasHexes() && draft.Elements.Levels->IsUniform())
  {
    local.emplace(cells, draft.Thin, draft.Elements, active, draft.Volumes, run);
  }
  method.StartMoves(cells, kinds, run, draft);
  MovePoints(cells, targets, local ? &*local : nullptr, method, run, draft, active);
  method.RestoreDraft(cells, run, draft);
  Mesh& mesh = draft.Elements;
  if (HasCurvedEdges(cells.Options))
  {
    mesh.Pulls = FindEdgePulls(draft.Facets, mesh, targets, active, run.TheRuntime);
  }
  active.CopyTo(mesh, cells.Grid);
  draft.Kinds = active.OfMesh(kinds, mesh);
}

} // namespace

void FitElements(const MeshCells& cells, ElementMethod& method, MeshRun& run, Draft& draft)
{
  // Before the interfaces, which would add to the peak of memory.
  ActiveMesh& active = method.MakeActive(cells, run, draft);
  MoveToTargets(cells, method, run, draft, active);
  method.EndMoves(run, draft);
}

} // namespace vfm
