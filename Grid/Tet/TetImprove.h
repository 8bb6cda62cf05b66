/**
 * Improvement of a tetrahedral mesh whose boundary stays.
 */
#pragma once

#include "Base/Options.h"
#include "Smoothing/TetEnergy.h"

#include <functional>

namespace vfm
{

/// The floors that the options ask for, and the ramp of tetrahedra.
TetQualityFloors FloorsOf(const MeshOptions& options);
const SmoothingRamp& TetRamp();

/// Moves the points after the first `fixed`. Points in units of cells. progress(fraction) is called after every sweep.
void ImproveInside(const TetEnergy& energy, std::size_t fixed,
  const std::vector<std::array<int, 4>>& tets, std::vector<Vector3>& points,
  const std::function<void(double)>& progress);

} // namespace vfm
