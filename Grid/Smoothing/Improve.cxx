#include "Smoothing/Improve.h"

#include "Base/PortableMath.h"

#include <cmath>

namespace vfm
{
namespace
{

// In the last stage of the ramp, targets are shifted after its first sweep and then every 5 sweeps,
// until 4 sweeps are left. More often, the volumes would oscillate.
constexpr int ShiftPeriod = 5;
constexpr int SweepsAfterShift = 4;
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
  CorrectedPart* FragmentTolerance };
constexpr int ResistingRounds = 8;
constexpr int Moves = 8;
constexpr int MoreMoves = 12;           // if fragments resist
constexpr int FewestMoves = 4;          // if small fragments are off
constexpr double FinalTolerance = 1e-7; // relative
constexpr VolumeTolerances Final{ CorrectedPart * FinalTolerance, CorrectedPart* FinalTolerance };
constexpr int BulgeRounds = 4; // of corrections, after each of which bulges are measured again
// Rounds of EndIntersections after which volumes are corrected, and points move again. Further
// rounds only put points back.
constexpr int CorrectedRounds = 4, MovingRounds = 30;

std::vector<double> Multiplied(std::vector<double> values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

/// Corrects the volumes of a mesh, in the last stage of the ramp and after it.
class VolumeCorrection
{
public:
  VolumeCorrection(const Improvement& what, Smoother& smoother, StageClock& clock) :
    What(what), TheSmoother(smoother), Clock(clock), Stage(what.Ramp.back())
  {
    this->Stage.Sweeps = SweepsPerCorrection;
  }

  /// Measures the volumes of the fragments. MeasureAll looks at all facets, also at new ones and at
  /// points that were not moved in sweeps.
  void Measure();
  void MeasureAll();

  /// Shifts the targets after a sweep of the last stage, if one is due, so that the surfaces come
  /// to rest where the volumes are right.
  /// @param sweep  number of the sweep in its stage, from 1
  void ShiftAfterSweep(int sweep);

  /// Shifts the targets and smooths, then moves the surface points to correct the remaining errors.
  /// Small fragments, whose surfaces are uncertain in the fractions and hard to move, get more
  /// rounds and longer shifts.
  void Run();
  /// Does so with curved elements too, whose volumes change as their points move.
  void RunCurved();
  /// Measures the volumes between straight and curved elements, if there are curved ones.
  void MeasureBulges();

private:
  FragmentVolumes& Volumes() const { return this->What.Volumes; }
  /// Returns whether an attachment may have a long offset.
  bool IsLong(const Attachment& a) const
  {
    return this->Volumes().IsSmall(a.Fragments[0]) || this->Volumes().IsSmall(a.Fragments[1]);
  }
  bool Follow();
  void FollowFragments(int rounds);

  const Improvement& What;
  Smoother& TheSmoother;
  StageClock& Clock;
  SmoothingStage Stage;
  bool IsMeasured = false;
};

void VolumeCorrection::Measure()
{
  if (this->IsMeasured)
  {
    this->Volumes().Measure(this->What.Active, this->TheSmoother.MovedPoints());
    this->TheSmoother.ForgetMoved();
  }
  else
  {
    this->MeasureAll();
  }
}

void VolumeCorrection::MeasureAll()
{
  this->Volumes().Measure(this->What.Active);
  this->TheSmoother.ForgetMoved();
  this->IsMeasured = true;
}

void VolumeCorrection::ShiftAfterSweep(int sweep)
{
  const SmoothingStage& stage = this->What.Ramp.back();
  if (sweep % ShiftPeriod == 1 && sweep + SweepsAfterShift <= stage.Sweeps)
  {
    this->Measure();
    this->MeasureBulges();
    this->TheSmoother.ShiftTargets(
      this->Volumes().FindShifts(this->What.Active, Rounds),
      [this](const Attachment& a) { return this->IsLong(a); }, stage);
  }
}

/// Runs one round. Returns false if all shifts were too small to matter.
bool VolumeCorrection::Follow()
{
  if (!this->TheSmoother.Follow(
        this->Volumes().FindShifts(this->What.Active, Rounds, true),
        [this](const Attachment& a) { return this->IsLong(a); }, this->Stage))
  {
    return false;
  }
  this->Measure();
  return true;
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
  const auto isOff = [&](int move)
  {
    return volumes.WorstError() > FinalTolerance ||
      (move < FewestMoves && volumes.WorstFragmentError() > FinalTolerance);
  };
  for (int move = 0; move < moves && isOff(move); ++move)
  {
    this->TheSmoother.MoveAlongNormals(volumes.FindShifts(this->What.Active, Final), this->Stage);
    this->Measure();
  }
}

void VolumeCorrection::RunCurved()
{
  this->MeasureBulges();
  this->Run();
  for (int round = 1; round < BulgeRounds && this->What.MeasureBulges; ++round)
  {
    this->MeasureBulges();
    if (!(this->Volumes().WorstError() > FinalTolerance))
    {
      break;
    }
    this->Run();
  }
}

void VolumeCorrection::MeasureBulges()
{
  if (this->What.MeasureBulges)
  {
    this->Volumes().SetBulges(this->What.MeasureBulges());
  }
}

} // namespace

void Improve(const Improvement& what, StageClock& clock, Runtime& runtime)
{
  clock.Start("Smoothing", 0.25);
  Smoother smoother(what.Active, &what.Targets, what.Energy, runtime);
  VolumeCorrection correction(what, smoother, clock);
  // AfterRamp may replace the facets.
  const bool shifts = what.ConserveVolume && !what.AfterRamp;
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
          what.AfterSweep(smoother, stage, sweep);
        }
        ++sweep;
        if (shifts && &stage == &what.Ramp.back())
        {
          correction.ShiftAfterSweep(sweep);
        }
      });
    done += share;
  }
  if (what.AfterRamp)
  {
    what.AfterRamp();
    correction.MeasureAll();
  }
  else
  {
    correction.Measure();
  }
  const auto correct = [&]
  {
    if (what.ConserveVolume)
    {
      clock.Start("Correcting volumes", 0.8);
      correction.RunCurved();
    }
  };
  correct();
  for (int round = 0; smoother.EndIntersections(what.Ramp.back(), round < MovingRounds); ++round)
  {
    correction.MeasureAll();
    if (round < CorrectedRounds)
    {
      correct();
    }
  }
  correction.MeasureBulges();
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
