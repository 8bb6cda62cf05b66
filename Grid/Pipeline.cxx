#include "Pipeline.h"

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
}

void Improve(const Improvement& what, StageClock& clock, Runtime& runtime)
{
  clock.Start("Smoothing", 0.25);
  Smoother smoother(what.Active, &what.Targets, what.Exchange, what.Energy, runtime);
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
