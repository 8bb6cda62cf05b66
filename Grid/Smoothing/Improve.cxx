#include "Smoothing/Improve.h"

#include "Base/PortableMath.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr int CorrectionRounds = 6;
constexpr int SweepsPerCorrection = 4;
constexpr double VolumeTolerance = 2e-4; // relative error, in the rounds with smoothing
constexpr int SmallRounds = 40;          // further rounds for small fragments only
constexpr double SmallTolerance = 5e-3;  // relative error of a small fragment
constexpr int Moves = 6;
constexpr int MoreMoves = 4;            // if fragments were excluded
constexpr double FinalTolerance = 1e-7; // relative

std::vector<double> Multiplied(std::vector<double> values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

/// Shifts the targets and smooths, then moves the surface points to correct the remaining errors.
/// Small fragments, whose surfaces are uncertain in the fractions and hard to move, get more rounds
/// and longer shifts.
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
      break; // MoveAlongNormals corrects the rest
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
  const int moves = Moves + (volumes.ExcludeSmall(SmallTolerance) ? MoreMoves : 0);
  for (int move = 0; move < moves && volumes.WorstError() > FinalTolerance; ++move)
  {
    smoother.MoveAlongNormals(volumes.FindShifts(what.Active), what.Ramp.back());
    volumes.Measure(what.Active);
  }
}

} // namespace

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
  const double cellVolume = Cube(grid.MeanWidth());
  report.TargetVolume = Multiplied(volumes.MaterialTargets(), cellVolume);
  report.MeshVolume = Multiplied(volumes.MaterialVolumes(), cellVolume);
  report.FragmentTargetVolume = Multiplied(volumes.FragmentTargets(), cellVolume);
  for (Index fragments : volumes.MaterialFragments())
  {
    report.Materials.push_back({ 0, fragments });
  }
}

} // namespace vfm
