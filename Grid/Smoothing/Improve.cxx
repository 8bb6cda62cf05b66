#include "Smoothing/Improve.h"

#include "Base/PortableMath.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr int CorrectionRounds = 6;
constexpr int SweepsPerCorrection = 4;
constexpr double VolumeTolerance = 2e-4;   // relative error, in the rounds with smoothing
constexpr int FurtherRounds = 6;           // before fragments resist
constexpr double FragmentTolerance = 5e-3; // relative error, in the further rounds
// Errors above which fragments resist, one after the other, and the rounds after each. The first
// selects few, so that their neighbours, which they pull off their targets, are not selected too.
constexpr double ResistingErrors[] = { 5e-2, FragmentTolerance };
// Fragments are corrected until their errors are within a part of the tolerances, so that they stay
// within these while their neighbours move.
constexpr double CorrectedPart = 0.5;
constexpr VolumeTolerances Rounds{ CorrectedPart * VolumeTolerance,
  CorrectedPart * FragmentTolerance };
constexpr int ResistingRounds = 8;
constexpr int Moves = 6;
constexpr int MoreMoves = 4;            // if fragments resist
constexpr double FinalTolerance = 1e-7; // relative
constexpr VolumeTolerances Final{ CorrectedPart * FinalTolerance, CorrectedPart * FinalTolerance };

std::vector<double> Multiplied(std::vector<double> values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

/// Corrects the volumes of a smoothed mesh.
class VolumeCorrection
{
public:
  VolumeCorrection(const Improvement& what, Smoother& smoother, StageClock& clock) :
    What(what), TheSmoother(smoother), Clock(clock), Stage(what.Ramp.back())
  {
    this->Stage.Sweeps = SweepsPerCorrection;
  }

  /// Shifts the targets and smooths, then moves the surface points to correct the remaining errors.
  /// Small fragments, whose surfaces are uncertain in the fractions and hard to move, get more
  /// rounds and longer shifts.
  void Run();

private:
  FragmentVolumes& Volumes() const { return this->What.Volumes; }
  bool Follow();
  void Measure();
  void FollowFragments(int rounds);

  const Improvement& What;
  Smoother& TheSmoother;
  StageClock& Clock;
  SmoothingStage Stage;
};

/// Runs one round. Returns false if all shifts were too small to matter.
bool VolumeCorrection::Follow()
{
  const FragmentVolumes& volumes = this->Volumes();
  const auto isSmall = [&volumes](const Attachment& a)
  { return volumes.IsSmall(a.Fragments[0]) || volumes.IsSmall(a.Fragments[1]); };
  ActiveMesh& active = this->What.Active;
  if (!this->TheSmoother.Follow(volumes.FindShifts(active, Rounds, true), isSmall, this->Stage))
  {
    return false;
  }
  this->Measure();
  return true;
}

void VolumeCorrection::Measure()
{
  this->Volumes().Measure(this->What.Active, this->TheSmoother.MovedPoints());
  this->TheSmoother.ForgetMoved();
}

/// Runs rounds until no fragment is off its aim.
void VolumeCorrection::FollowFragments(int rounds)
{
  const FragmentVolumes& volumes = this->Volumes();
  for (int round = 0; round < rounds; ++round)
  {
    if (!(volumes.WorstFragmentError() > FragmentTolerance) || !this->Follow())
    {
      break;
    }
    this->Clock.Update(0.92);
  }
}

void VolumeCorrection::Run()
{
  FragmentVolumes& volumes = this->Volumes();
  for (int round = 0;
       round < CorrectionRounds && volumes.WorstError() > VolumeTolerance && this->Follow();
       ++round)
  {
    this->Clock.Update(0.8 + 0.02 * round);
  }
  this->FollowFragments(FurtherRounds);
  bool resists = false;
  for (double error : ResistingErrors)
  {
    resists = volumes.MarkResisting(error);
    this->FollowFragments(ResistingRounds);
  }
  const int moves = Moves + (resists ? MoreMoves : 0);
  for (int move = 0; move < moves && volumes.WorstError() > FinalTolerance; ++move)
  {
    this->TheSmoother.MoveAlongNormals(volumes.FindShifts(this->What.Active, Final), this->Stage);
    this->Measure();
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
  smoother.ForgetMoved();
  if (what.ConserveVolume)
  {
    clock.Start("Correcting volumes", 0.8);
    VolumeCorrection(what, smoother, clock).Run();
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
