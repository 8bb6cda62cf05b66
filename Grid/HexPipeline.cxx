#include "HexPipeline.h"

#include "Geometry.h"
#include "Quality.h"
#include "Smoother.h"
#include "Volumes.h"

#include <chrono>
#include <cmath>

namespace vfm
{
namespace
{

constexpr int CorrectionRounds = 6;
constexpr int SweepsPerCorrection = 4;
constexpr double VolumeTolerance = 2e-4; // relative, of the rounds with smoothing
constexpr int Nudges = 4;
constexpr double FinalTolerance = 1e-7; // relative

/// Names the running stage, times it and tells the progress.
class StageClock
{
public:
  StageClock(Runtime& runtime, HexMeshReport& report) : Run(runtime), Report(report) {}
  ~StageClock() { this->Stop(); }
  void Start(const char* name, double fraction)
  {
    this->Stop();
    this->Report.Stages.push_back({ name, 0.0 });
    this->Begin = std::chrono::steady_clock::now();
    this->Run.Progress(fraction, name);
  }
  void Update(double fraction) { this->Run.Progress(fraction, this->Report.Stages.back().Name); }

private:
  void Stop()
  {
    if (!this->Report.Stages.empty())
    {
      this->Report.Stages.back().Seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Begin).count();
    }
  }
  Runtime& Run;
  HexMeshReport& Report;
  std::chrono::steady_clock::time_point Begin;
};

void CheckOptions(const HexMeshOptions& options)
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
}

double TargetJacobian(const FractionField& fractions, const HexMeshOptions& options)
{
  const bool several = fractions.NumberOfMaterials() > 1 || options.MeshVoid;
  return options.TargetScaledJacobian > 0.0 ? options.TargetScaledJacobian : (several ? 0.5 : 0.55);
}

/// Moves the interfaces until the volumes of the fragments are those of the fractions: shifts the targets and
/// smooths, then moves the surface points themselves by the little that is left.
void CorrectVolumes(FragmentVolumes& volumes, SurfaceTargets& targets, const ActiveMesh& active,
  Smoother& smoother, StageClock& clock)
{
  SmoothingStage stage = SmoothingRamp().back();
  stage.Sweeps = SweepsPerCorrection;
  for (int round = 0; round < CorrectionRounds && volumes.WorstError() > VolumeTolerance; ++round)
  {
    targets.Shift(volumes.FindShifts());
    smoother.RunStage(stage, [&](double) { clock.Update(0.8 + 0.02 * round); });
    volumes.Measure(active);
  }
  for (int nudge = 0; nudge < Nudges && volumes.WorstError() > FinalTolerance; ++nudge)
  {
    smoother.Nudge(volumes.FindShifts());
    volumes.Measure(active);
  }
}

void Smooth(const FractionField& fractions, const LabelArray& labels, const Interface& interface,
  const PointNumbering& numbering, const Partition& partition, const HexMeshOptions& options,
  FragmentVolumes& volumes, HexMesh& mesh, Runtime& runtime, StageClock& clock)
{
  clock.Start("Fitting surfaces", 0.2);
  SurfaceTargets targets(interface,
    options.Method == Smoothing::GeometryBased ? SurfaceTargets::Kind::Facets
                                               : SurfaceTargets::Kind::Quadrics,
    runtime);
  ActiveMesh active(interface, numbering, labels, partition, mesh);
  const PointExchange exchange(active, mesh, interface.Grid(), partition);
  clock.Start("Smoothing", 0.25);
  Smoother smoother(
    active, interface, targets, exchange, TargetJacobian(fractions, options), runtime);
  double done = 0.25;
  for (const SmoothingStage& stage : SmoothingRamp())
  {
    const double share = 0.01 * stage.Sweeps;
    smoother.RunStage(stage, [&](double fraction) { clock.Update(done + share * fraction); });
    done += share;
  }
  volumes.Measure(active);
  if (options.ConserveVolume && options.IsoValue == 0.5)
  {
    clock.Start("Correcting volumes", 0.8);
    CorrectVolumes(volumes, targets, active, smoother, clock);
  }
  active.CopyTo(mesh, interface.Grid());
}

std::vector<double> Multiplied(std::vector<double> values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

} // namespace

HexMesh MakeHexMesh(const CartesianGrid& grid, const FractionField& fractions,
  const HexMeshOptions& options, Runtime& runtime, HexMeshReport& report)
{
  CheckOptions(options);
  report = HexMeshReport();
  StageClock clock(runtime, report);
  clock.Start("Assigning materials", 0.0);
  LabelArray labels = AssignMaterials(grid, fractions, options.IsoValue);
  clock.Start("Resolving labels", 0.05);
  const Partition partition(grid, runtime.Group());
  const ResolveReport resolved = ResolveLabels(grid, fractions, labels, partition);
  report.FlippedCells = resolved.FlippedCells;
  report.ResolveRounds = resolved.Rounds;
  clock.Start("Making hexahedra", 0.1);
  const std::vector<Index> mixed = FindMixedNodes(grid, labels);
  PointNumbering numbering(grid, labels, options.MeshVoid);
  HexMesh mesh = BuildHexes(grid, labels, mixed, options.StairStep, numbering, runtime);
  clock.Start("Finding geometry", 0.12);
  const Fragments fragments(grid, labels, options.MeshVoid, partition);
  FindGeometry(grid, labels, mixed, fragments, numbering, partition, mesh, report);
  clock.Start("Finding interfaces", 0.15);
  const bool smooth = !options.StairStep && options.Method != Smoothing::Off;
  const Interface interface(
    grid, fractions, labels, smooth ? mixed : std::vector<Index>(), options.IsoValue, runtime);
  FragmentVolumes volumes(fractions, labels, interface, fragments, partition);
  if (smooth)
  {
    Smooth(
      fractions, labels, interface, numbering, partition, options, volumes, mesh, runtime, clock);
  }
  KeepOwned(mesh, grid);
  const double cellVolume = std::pow(grid.MeanWidth(), 3.0);
  report.TargetVolume = Multiplied(volumes.MaterialTargets(), cellVolume);
  report.MeshVolume = Multiplied(volumes.MaterialVolumes(), cellVolume);
  if (options.ComputeQuality)
  {
    clock.Start("Measuring quality", 0.95);
    ComputeQuality(mesh, runtime, report);
  }
  return mesh;
}

} // namespace vfm
