/**
 * The volume of a trilinear hex.
 */
#pragma once

#include "Base/Vector3.h"

namespace vfm
{

/// Returns the volume of the trilinear hex between the quads a and b, whose corners are in VTK's
/// order. The Gauss rule with 2x2x2 points is exact.
double VolumeBetween(const std::array<Vector3, 4>& a, const std::array<Vector3, 4>& b);

/// Returns the volume of the hex with these corners, in VTK's order, after scaling of its lengths.
/// Coordinates are taken relative to the first corner, which limits rounding errors if they are
/// large.
inline double VolumeOfHex(const std::array<Vector3, 8>& x, double scale = 1.0)
{
  std::array<Vector3, 4> lower, upper;
  for (int c = 0; c < 4; ++c)
  {
    lower[c] = scale * (x[c] - x[0]);
    upper[c] = scale * (x[c + 4] - x[0]);
  }
  return VolumeBetween(lower, upper);
}

} // namespace vfm
