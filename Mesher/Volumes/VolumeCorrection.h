/**
 * VolumeCorrection: moves the interfaces of a mesh until the volumes of its fragments match the
 * fractions: in the last stage of the ramp of smoothing, and after it.
 */
#pragma once

#include "Elements/StageClock.h"
#include "Smoothing/Smoother.h"
#include "Volumes/FragmentVolumes.h"
#include "Volumes/LocalVolumes.h"

namespace vfm
{

/// Corrects the volumes of fragments to a relative error of 1e-7, or until the rounds are used up.
/// All functions are collective.
class VolumeCorrection
{
public:
  /// Measures FragmentVolumes::SetBulges at the present positions. Collective; empty: elements stay
  /// straight.
  using MeasureBulgesFunction = std::function<std::vector<double>()>;

  /// All objects must outlive this one.
  /// @param last  last stage of the ramp
  /// @param isThin  FindThinFragments
  /// @param local  shifts near thin cells in the ramp; null: there are none
  VolumeCorrection(FragmentVolumes& volumes, Smoother& smoother, StageClock& clock,
    const SmoothingStage& last, const std::vector<unsigned char>& isThin, const LocalVolumes* local,
    MeasureBulgesFunction bulgesOf);

  /// Measures the volumes of the fragments. MeasureAll looks at all facets, also at new ones and at
  /// points that were not moved in sweeps.
  void Measure();
  void MeasureAll();
  /// Measures the volumes between straight and curved elements, if there are curved ones.
  void MeasureBulges();

  /// Shifts the targets after a sweep of the last stage, if one is due, so that the surfaces come
  /// to rest where the volumes are right.
  /// @param sweep  number of the sweep in its stage, from 1
  void ShiftAfterSweep(int sweep);

  /// Shifts the targets and smooths, then moves the surface points to correct the remaining errors.
  /// Small fragments, whose surfaces are uncertain in the fractions and hard to move, get more
  /// rounds and longer shifts. Fragments with thin parts that still miss their targets get elements
  /// of less quality (ActiveMesh::LowerDemands), as few as needed. The volumes of curved elements
  /// change as their points move: they are measured again, and corrected.
  void Run();

private:
  ActiveMesh& Active() const { return this->TheSmoother.TheMesh(); }
  /// Return whether an attachment may have a long offset: those of small fragments, and near thin
  /// cells also those of fragments with thin parts.
  bool IsLong(const Attachment& a) const
  {
    return this->Volumes.IsSmall(a.Fragments[0]) || this->Volumes.IsSmall(a.Fragments[1]);
  }
  bool IsLongLocally(const Attachment& a) const
  {
    return this->IsLong(a) ||
      (this->Local && (this->IsThin[a.Fragments[0]] || this->IsThin[a.Fragments[1]]));
  }
  void CorrectStraight();
  void ScaleFree();
  std::vector<double> FindShifts();
  using LongOffsets = bool (VolumeCorrection::*)(const Attachment&) const;
  bool Follow(const std::vector<double>& shifts, LongOffsets isLong = &VolumeCorrection::IsLong);
  void FollowFragments();
  bool FollowOff(const std::vector<unsigned char>& fragments);
  void Yield(const std::vector<unsigned char>& fragments, float demand);
  std::vector<unsigned char> FindCrumpled() const;
  void YieldWithoutCrumpling(std::vector<unsigned char>& fragments, float demand);
  void CorrectThin();
  void CorrectLocally();
  void MoveSurfaces();

  FragmentVolumes& Volumes;
  Smoother& TheSmoother;
  StageClock& Clock;
  SmoothingStage Last, Round; // stages of the ramp's end, and of a round
  const std::vector<unsigned char>& IsThin;
  const LocalVolumes* Local;
  MeasureBulgesFunction BulgesOf;
  bool IsMeasured = false;
};

} // namespace vfm
