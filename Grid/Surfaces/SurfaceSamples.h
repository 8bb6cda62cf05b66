/**
 * SurfaceSamples: points spread over a closed surface by area, and its connected components.
 */
#pragma once

#include "Surfaces/ClosedSurface.h"

namespace vfm
{

/// Connected components of a surface, numbered by their first triangles.
struct SurfaceComponents
{
  std::vector<int> OfTriangle;
  std::vector<double> Volumes; ///< below 0: the wall of a cavity
  int Solids = 0;              ///< number of components with positive volumes
};

SurfaceComponents FindComponents(const ClosedSurface& surface);

double MeasureArea(const ClosedSurface& surface);

/// Point that stands for a part of a surface.
struct SurfaceSample
{
  Vector3 Point, Normal; ///< the normal is a unit vector that faces outwards
  double Area = 0.0;     ///< of the part
  int Triangle = 0;
};

/// Spreads points over a surface by area, at least some in each component. Their number and places
/// depend only on the surface.
/// @param count  number of samples, approximately
std::vector<SurfaceSample> SampleSurface(
  const ClosedSurface& surface, const SurfaceComponents& components, int count);

} // namespace vfm
