/**
 * Improve: smooths a mesh and moves its interfaces until the volumes of its fragments match
 * the fractions.
 */
#pragma once

#include "Elements/StageClock.h"
#include "Smoothing/Smoother.h"
#include "Volumes/FragmentVolumes.h"

namespace vfm
{

/// Arguments of Improve. All objects must outlive the call.
struct Improvement
{
  ActiveMesh& Active;
  const SurfaceTargets& Targets;
  const ElementEnergy& Energy;
  const SmoothingRamp& Ramp;
  FragmentVolumes& Volumes;
  /// Receives the number of points, sweeps and visits.
  MeshReport& Report;
  bool ConserveVolume;
  /// Is called after each sweep with its number in the stage, from 0; may be empty.
  std::function<void(Smoother&, const SmoothingStage&, int)> AfterSweep;
  /// Is called after the ramp, before volumes are measured; may be empty.
  std::function<void()> AfterRamp;
  /// Measures FragmentVolumes::SetBulges at the present positions. Collective; empty: elements stay
  /// straight.
  std::function<std::vector<double>()> MeasureBulges;
};

/// Smooths a mesh. If ConserveVolume is set, moves the interfaces until the relative errors of the
/// volumes are at most 1e-7 or the rounds are used up.
/// @param clock  receives the stages and their progress
/// @pre Collective.
void Improve(const Improvement& what, StageClock& clock, Runtime& runtime);

/// Writes the volumes of materials and fragments into a report, in length units cubed, and the
/// number of fragments per material.
void ReportVolumes(const CartesianGrid& grid, const FragmentVolumes& volumes, MeshReport& report);

} // namespace vfm
