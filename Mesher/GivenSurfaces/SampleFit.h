/**
 * SampleFit: fits quadrics to the samples of a surface around a place.
 */
#pragma once

#include "GivenSurfaces/NearSurface.h"
#include "Interface/LocalQuadric.h"

#include <optional>

namespace vfm
{

/// Part of a surface around a place. Normals point to the second label of a pair.
struct SurfacePart
{
  static constexpr int AnySheet = -1;

  Vector3 Centre, Normal;
  int Sheet = AnySheet;
  /// Samples whose normal is nearer to this one than to Normal are left out; zero: none are.
  Vector3 Other{};
};

/// Distances, in cells, of the samples that count.
struct FitRange
{
  double Radius, Sigma; ///< weights are Gaussians of the width Sigma
};

struct SampleFit
{
  LocalQuadric Surface;
  double Error; ///< weighted rms distance of the samples
};

/// Fits a quadric. If its error is above 0.02, tries smaller ranges, and returns the best fit.
/// @param samples  around the part, in the local frame of a node
/// @return nothing if fewer than three samples count, or the surface is steep over its base
std::optional<SampleFit> FitSamples(
  const std::vector<NearSample>& samples, const SurfacePart& part, const FitRange& range);

} // namespace vfm
