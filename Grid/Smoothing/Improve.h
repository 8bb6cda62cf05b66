/**
 * Improve: a mesh smoothed, and its interfaces moved until the volumes of its fragments are those of the fractions.
 */
#pragma once

#include "Mesh/StageClock.h"
#include "Smoothing/Smoother.h"
#include "Smoothing/Volumes.h"

namespace vfm
{

/// What improves a mesh; all of it outlives the call.
struct Improvement
{
  ActiveMesh& Active;
  const SurfaceTargets& Targets;
  const ElementEnergy& Energy;
  const SmoothingRamp& Ramp;
  FragmentVolumes& Volumes;
  MeshReport& Report; ///< gets what it took
  bool ConserveVolume;
  std::function<void(Smoother&, const SmoothingStage&, int)>
    AfterSweep;                    ///< with the number of the sweep; may be empty
  std::function<void()> AfterRamp; ///< before volumes are measured; may be empty
};

/// Smooths, then moves the interfaces until the volumes of the fragments are those of the fractions. Collective.
void Improve(const Improvement& what, StageClock& clock, Runtime& runtime);

/// Volumes per material and fragment in length units of the grid.
void ReportVolumes(const CartesianGrid& grid, const FragmentVolumes& volumes, MeshReport& report);

} // namespace vfm
