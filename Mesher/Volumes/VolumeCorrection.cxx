#include "Volumes/VolumeCorrection.h"

#include "Smoothing/Intersections.h"
#include "Volumes/ScaleFragments.h"

#include <limits>

namespace vfm
{
namespace
{

// In the last stage of the ramp, targets are shifted after its first sweep and then every 5 sweeps,
// until 4 sweeps are left. More often, the volumes would oscillate. Local shifts are larger: they
// begin after 11 sweeps, and need more sweeps to settle.
constexpr struct
{
  int First, Period;
} ShiftSweeps{ 1, 5 }, LocalShiftSweeps{ 11, 15 };
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
constexpr int FewestMoves = 4; // if small fragments are off
// Moves end after a number of them, or once the error was not within this part of the least one
// several times in turn.
constexpr double PartThatCounts = 0.9;
constexpr struct
{
  int Most, Idle;
} Moves{ 20, 3 }, FlatMoves{ 60, 12 }; // FlatMoves: of meshes of a plane, which are small
// Demands of thin fragments, and the relative error above which they get them: the lower a demand,
// the more of its volume must a fragment miss.
constexpr struct
{
  float Demand;
  double Error;
} Yields[] = { { 0.8f, FragmentTolerance }, { 0.6f, FragmentTolerance }, { 0.4f, 1e-2 } };
// A fragment has this number of rounds with a demand, or until its error did not fall this many
// times in turn.
constexpr int YieldingRounds = 16, IdleRounds = 4;
// Demand of hexes near thin cells whose surroundings contain more than the fractions by more than
// this share, and rounds of local shifts with it.
constexpr float LocalDemand = 0.84f;
constexpr double LocalExcess = 0.1;
constexpr int LocalRounds = 2;
constexpr int BulgeRounds = 4; // of corrections, after each of which bulges are measured again

/// What rounds and lower demands change in an active mesh.
struct RoundState
{
  explicit RoundState(const ActiveMesh& mesh) :
    X(mesh.X), Attachments(mesh.Attachments), Demands(mesh.Demands)
  {
  }
  void Restore(ActiveMesh& mesh)
  {
    mesh.X.swap(this->X);
    mesh.Attachments.swap(this->Attachments);
    mesh.Demands.swap(this->Demands);
  }

  std::vector<Vector3> X;
  std::vector<Attachment> Attachments;
  std::vector<float> Demands;
};

} // namespace

VolumeCorrection::VolumeCorrection(FragmentVolumes& volumes, Smoother& smoother, StageClock& clock,
  const SmoothingStage& last, const std::vector<unsigned char>& isThin, const LocalVolumes* local,
  MeasureBulgesFunction bulgesOf) :
  Volumes(volumes),
  TheSmoother(smoother),
  Clock(clock),
  Last(last),
  Round(last),
  IsThin(isThin),
  Local(local),
  BulgesOf(std::move(bulgesOf))
{
  this->Round.Sweeps = SweepsPerRound;
}

void VolumeCorrection::Measure()
{
  if (this->IsMeasured)
  {
    this->Volumes.Measure(this->Active(), this->TheSmoother.MovedPoints());
    this->TheSmoother.ForgetMoved();
  }
  else
  {
    this->MeasureAll();
  }
}

void VolumeCorrection::MeasureAll()
{
  this->Volumes.Measure(this->Active());
  this->TheSmoother.NoteAllMoved();
  this->TheSmoother.ForgetMoved();
  this->IsMeasured = true;
}

void VolumeCorrection::ShiftAfterSweep(int sweep)
{
  const auto& [first, period] = this->Local ? LocalShiftSweeps : ShiftSweeps;
  if (sweep % period == first && sweep + SweepsAfterShift <= this->Last.Sweeps)
  {
    this->Measure();
    this->MeasureBulges();
    std::vector<double> shifts = this->Volumes.FindShifts(this->Active(), InRamp);
    if (this->Local)
    {
      this->Local->ReplaceShifts(this->Local->Measure(this->Active()), this->Active(), shifts);
    }
    this->TheSmoother.ShiftTargets(
      shifts, [this](const Attachment& a) { return this->IsLongLocally(a); }, this->Last);
  }
}

/// Gives free fragments that are off their targets.
void VolumeCorrection::ScaleFree()
{
  std::vector<double> scales = this->Volumes.FindScales(FragmentTolerance);
  for (double& scale : scales) // of areas, if the height of the elements is fixed
  {
    scale *= this->Active().Columns.empty() ? 1.0 : std::sqrt(scale);
  }
  if (this->TheSmoother.TheRuntime().Group().Any(
        std::any_of(scales.begin(), scales.end(), [](double scale) { return scale != 1.0; })))
  {
    this->TheSmoother.NoteMoved(
      ScaleFragments(this->TheSmoother.TheTargets(), this->TheSmoother.TheEnergy(), this->Round,
        this->Volumes.Share(), scales, this->TheSmoother.TheRuntime(), this->Active()));
    this->Measure();
  }
}

/// Returns the shifts of a round.
std::vector<double> VolumeCorrection::FindShifts()
{
  return this->Volumes.FindShifts(this->Active(), InRounds);
}

/// Runs one round with shifts of attachments. Returns false if all were too small to matter.
bool VolumeCorrection::Follow(const std::vector<double>& shifts, LongOffsets isLong)
{
  if (!this->TheSmoother.Follow(
        shifts, [&](const Attachment& a) { return (this->*isLong)(a); }, this->Round))
  {
    return false;
  }
  this->Measure();
  return true;
}

/// Runs rounds until no fragment is off its aim or pushed.
void VolumeCorrection::FollowFragments()
{
  const FragmentVolumes& volumes = this->Volumes;
  const auto isDue = [&]
  { return volumes.WorstFragmentError() > FragmentTolerance || volumes.HasPushed(); };
  for (int round = 0; round < ResistingRounds && isDue() && this->Follow(this->FindShifts());
       ++round)
  {
    this->Clock.Update(0.82 + 0.01 * round);
  }
}

void VolumeCorrection::CorrectStraight()
{
  if (this->Volumes.WorstError() > VolumeTolerance)
  {
    this->Follow(this->FindShifts());
  }
  for (double error : ResistingErrors)
  {
    this->ScaleFree();
    this->Volumes.MarkResisting(error);
    this->FollowFragments();
  }
  this->Clock.Update(0.92);
  this->MoveSurfaces();
}

/// Moves surface points along their normals until volumes are right or errors do not fall.
void VolumeCorrection::MoveSurfaces()
{
  FragmentVolumes& volumes = this->Volumes;
  volumes.ForgetRequests(); // sweeps tell nothing about moves along normals
  double least = std::numeric_limits<double>::infinity();
  const auto& [most, mostIdle] = this->Active().Columns.empty() ? Moves : FlatMoves;
  for (int move = 0, idle = 0; move < most && idle < mostIdle; ++move)
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
    this->TheSmoother.MoveAlongNormals(volumes.FindShifts(this->Active(), InMoves), this->Round);
    this->Measure();
  }
}

/// Runs a round for flagged fragments and those that they pulled off their targets. Returns false
/// if all shifts were too small to matter.
bool VolumeCorrection::FollowOff(const std::vector<unsigned char>& fragments)
{
  const std::vector<unsigned char> isOff = this->Volumes.FindOff(FragmentTolerance);
  std::vector<double> shifts = this->FindShifts();
  ForEach(this->TheSmoother.TheRuntime(), shifts.size(),
    [&](Index i)
    {
      const auto& [first, second] = this->Active().Attachments[i].Fragments;
      const bool follows = fragments[first] || fragments[second] || isOff[first] || isOff[second];
      shifts[i] = follows ? shifts[i] : 0.0;
    });
  return this->Follow(shifts);
}

/// Lowers the demands of flagged fragments, and follows their errors to where they are smallest.
/// Lower demands leave thin elements less stable, so the errors may grow again.
void VolumeCorrection::Yield(const std::vector<unsigned char>& fragments, float demand)
{
  this->Active().LowerDemands(fragments, demand);
  this->Volumes.ForgetResisting(fragments);
  this->Volumes.ForgetRequests();
  RoundState best(this->Active());
  double least = this->Volumes.SumErrors(fragments);
  for (int round = 0, idle = 0;
       round < YieldingRounds && idle < IdleRounds && this->FollowOff(fragments); ++round)
  {
    const double error = this->Volumes.SumErrors(fragments);
    idle = error < least ? 0 : idle + 1;
    if (idle == 0)
    {
      least = error;
      best = RoundState(this->Active());
    }
  }
  best.Restore(this->Active());
  this->MeasureAll();
  this->Volumes.MarkResisting(ResistingErrors[0]);
  this->MoveSurfaces();
}

/// Returns which fragments have facets that intersect others.
std::vector<unsigned char> VolumeCorrection::FindCrumpled() const
{
  ActiveMesh& active = this->Active();
  Runtime& runtime = this->TheSmoother.TheRuntime();
  std::vector<unsigned char> intersects = FindIntersections(active, runtime);
  active.Exchange.SendAll([&](int mover) { return intersects[mover]; },
    [&](int mover, unsigned char flag) { intersects[mover] = flag; });
  std::vector<unsigned char> crumpled(this->IsThin.size(), 0);
  for (const ActiveFacet& facet : active.Facets)
  {
    const bool isCrumpled = std::any_of(
      facet.Points.begin(), facet.Points.end(), [&](int point) { return intersects[point]; });
    crumpled[facet.Fragments[0]] |= isCrumpled;
    crumpled[facet.Fragments[1]] |= isCrumpled;
  }
  this->Volumes.Share().Unite(crumpled);
  return crumpled;
}

/// Lowers the demands of flagged fragments, except those that would crumple: their points would go
/// back to their start for good (Smoother::EndIntersections).
/// @param[in,out] fragments  those that would crumple are removed
void VolumeCorrection::YieldWithoutCrumpling(std::vector<unsigned char>& fragments, float demand)
{
  Ranks& ranks = this->TheSmoother.TheRuntime().Group();
  while (ranks.Any(std::find(fragments.begin(), fragments.end(), 1) != fragments.end()))
  {
    RoundState before(this->Active());
    this->Yield(fragments, demand);
    const std::vector<unsigned char> isCrumpled = this->FindCrumpled();
    bool hasRemoved = false;
    for (std::size_t f = 1; f < fragments.size(); ++f)
    {
      hasRemoved = hasRemoved || (fragments[f] && isCrumpled[f]);
      fragments[f] &= !isCrumpled[f];
    }
    if (!ranks.Any(hasRemoved))
    {
      return;
    }
    before.Restore(this->Active());
    this->MeasureAll();
  }
}

/// Lowers the demands of thin fragments that cannot reach their targets.
void VolumeCorrection::CorrectThin()
{
  std::vector<unsigned char> fragments = this->IsThin;
  for (const auto& [demand, error] : Yields)
  {
    const std::vector<unsigned char> isOff = this->Volumes.FindOff(error);
    std::transform(isOff.begin(), isOff.end(), fragments.begin(), fragments.begin(),
      [](unsigned char off, unsigned char yields) { return off && yields; });
    this->YieldWithoutCrumpling(fragments, demand);
  }
}

/// Lowers the demands of hexes near thin cells where there is too much material, and shifts
/// interfaces there.
void VolumeCorrection::CorrectLocally()
{
  ActiveMesh& active = this->Active();
  CellVolumes volumes = this->Local->Measure(active);
  const std::vector<unsigned char> exceeds = this->Local->FindExcess(volumes, active, LocalExcess);
  const bool isAny = std::find(exceeds.begin(), exceeds.end(), 1) != exceeds.end();
  if (!this->TheSmoother.TheRuntime().Group().Any(isAny))
  {
    return;
  }
  active.LowerDemandsOf(exceeds, LocalDemand);
  for (int round = 0; round < LocalRounds; ++round)
  {
    if (round > 0)
    {
      volumes = this->Local->Measure(active);
    }
    std::vector<double> shifts = this->FindShifts();
    this->Local->ReplaceShifts(volumes, active, shifts);
    if (!this->Follow(shifts, &VolumeCorrection::IsLongLocally))
    {
      break;
    }
  }
}

void VolumeCorrection::Run()
{
  this->MeasureBulges();
  if (this->Local)
  {
    this->CorrectLocally();
  }
  this->CorrectStraight();
  if (!this->IsThin.empty())
  {
    this->CorrectThin();
  }
  for (int round = 1; round < BulgeRounds && this->BulgesOf; ++round)
  {
    this->MeasureBulges();
    if (!(this->Volumes.WorstError() > FinalTolerance))
    {
      break;
    }
    this->CorrectStraight();
  }
}

void VolumeCorrection::MeasureBulges()
{
  if (this->BulgesOf)
  {
    this->Volumes.SetBulges(this->BulgesOf());
  }
}

} // namespace vfm
