/**
 * TetImprove: settings of the smoothing of tets, and smoothing of a mesh with a fixed boundary.
 */
#pragma once

#include "Base/Options.h"
#include "Smoothing/Tet/TetEnergy.h"

#include <functional>

namespace vfm
{

/// Returns the floors of TetEnergy that match the options.
TetQualityFloors FloorsOf(const MeshOptions& options);
/// Returns the stages of smoothing of tets. Methods differ in the weight of distances.
const SmoothingRamp& TetRamp(TetMethod method = TetMethod::Cells);

/// Moves the points of a mesh, except its first `fixed` ones, to reduce the energy of its tets.
/// @param points  points in grid coordinates (Interface.h)
/// @param progress  progress(fraction) is called after every sweep
void ImproveInside(const TetEnergy& energy, std::size_t fixed,
  const std::vector<std::array<int, 4>>& tets, std::vector<Vector3>& points,
  const std::function<void(double)>& progress);

} // namespace vfm
