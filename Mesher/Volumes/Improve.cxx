#include "Volumes/Improve.h"

#include "Base/PortableMath.h"

#include "Volumes/ScaleFragments.h"

#include <cmath>
#include <limits>

namespace vfm
{
namespace
{

// In the last stage of the ramp, targets are shifted after its first sweep and then every 5 sweeps,
// until 4 sweeps are left. More often, the volumes would oscillate.
constexpr int ShiftPeriod = 5;
constexpr int SweepsAfterShift = 4;
constexpr int SweepsPerRound = 4;
constexpr double VolumeTolerance = 2e-4;   // relative error
constexpr double FragmentTolerance = 5e-3; // of any fragment
// Errors above which fragments resist, one after the other, and the rounds after each. The first
// selects few, so that their neighbours, which they pull off their targets, are not selected too.
constexpr double ResistingErrors[] = { 5e-2, FragmentTolerance };
constexpr int ResistingRounds = 8;
constexpr double FinalTolerance = 1e-7; // relative error
// Fragments are corrected until their errors are within half the tolerances, so that they stay
// within these while their neighbours move. Larger factors in the ramp would make volumes
// oscillate.
constexpr VolumeRules InRamp{ { 0.5 * VolumeTolerance, 1.0 }, { 0.5 * FragmentTolerance, 2.0 },
  true };
constexpr VolumeRules InRounds{ { 0.5 * VolumeTolerance, 3.0 }, { 0.5 * FragmentTolerance, 3.0 },
  true };
// A fragment that cannot move would pull its neighbours off their targets.
constexpr VolumeRules InMoves{ { 0.5 * FinalTolerance, 3.0 }, { 0.5 * FinalTolerance, 3.0 },
  false };
constexpr int Moves = 20;
constexpr int FewestMoves = 4; // if small fragments are off
// Moves end once the error was not within this part of the least one this many times in turn.
constexpr double PartThatCounts = 0.9;
constexpr int IdleMoves = 3;
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
  VolumeCorrection(
    const Improvement& what, Smoother& smoother, StageClock& clock, Runtime& runtime) :
    What(what), TheSmoother(smoother), Clock(clock), TheRuntime(runtime), Stage(what.Ramp.back())
  {
    this->Stage.Sweeps = SweepsPerRound;
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
  void ScaleFree();
  bool Follow();
  void FollowFragments();
  void MoveSurfaces();

  const Improvement& What;
  Smoother& TheSmoother;
  StageClock& Clock;
  Runtime& TheRuntime;
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
      this->Volumes().FindShifts(this->What.Active, InRamp),
      [this](const Attachment& a) { return this->IsLong(a); }, stage);
  }
}

/// Gives free fragments that are off their targets.
void VolumeCorrection::ScaleFree()
{
  const std::vector<double> scales = this->Volumes().FindScales(FragmentTolerance);
  if (std::any_of(scales.begin(), scales.end(), [](double scale) { return scale != 1.0; }))
  {
    this->TheSmoother.NoteMoved(ScaleFragments(this->What.Targets, this->What.Energy, this->Stage,
      scales, this->TheRuntime, this->What.Active));
    this->Measure();
  }
}

/// Runs one round. Returns false if all shifts were too small to matter.
bool VolumeCorrection::Follow()
{
  if (!this->TheSmoother.Follow(
        this->Volumes().FindShifts(this->What.Active, InRounds),
        [this](const Attachment& a) { return this->IsLong(a); }, this->Stage))
  {
    return false;
  }
  this->Measure();
  return true;
}

/// Runs rounds until no fragment is off its aim or pushed.
void VolumeCorrection::FollowFragments()
{
  const FragmentVolumes& volumes = this->Volumes();
  const auto isDue = [&]
  { return volumes.WorstFragmentError() > FragmentTolerance || volumes.HasPushed(); };
  for (int round = 0; round < ResistingRounds && isDue() && this->Follow(); ++round)
  {
    this->Clock.Update(0.82 + 0.01 * round);
  }
}

void VolumeCorrection::Run()
{
  FragmentVolumes& volumes = this->Volumes();
  if (volumes.WorstError() > VolumeTolerance)
  {
    this->Follow();
  }
  for (double error : ResistingErrors)
  {
    this->ScaleFree();
    volumes.MarkResisting(error);
    this->FollowFragments();
  }
  this->Clock.Update(0.92);
  this->MoveSurfaces();
}

/// Moves surface points along their normals until volumes are right or errors do not fall.
void VolumeCorrection::MoveSurfaces()
{
  FragmentVolumes& volumes = this->Volumes();
  volumes.ForgetRequests(); // sweeps tell nothing about moves along normals
  double least = std::numeric_limits<double>::infinity();
  for (int move = 0, idle = 0; move < Moves && idle < IdleMoves; ++move)
  {
    const double error = volumes.WorstError();
    const bool isOff = error > FinalTolerance ||
      (move < FewestMoves && volumes.WorstFragmentError() > FinalTolerance);
    if (!isOff)
    {
      break;
    }
    idle = error <= PartThatCounts * least ? 0 : idle + 1;
    least = std::min(least, error);
    this->TheSmoother.MoveAlongNormals(volumes.FindShifts(this->What.Active, InMoves), this->Stage);
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
  VolumeCorrection correction(what, smoother, clock, runtime);
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
  std::vector<std::int64_t> sums{ smoother.Points(), smoother.Visits() };
  runtime.Group().Sum(sums);
  what.Report.SmoothedPoints = sums[0];
  what.Report.Sweeps = smoother.Sweeps();
  what.Report.Visits = sums[1];
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
