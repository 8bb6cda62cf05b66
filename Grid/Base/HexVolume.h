/**
 * The volume of a trilinear hex.
 */
#pragma once

#include "Base/Vector3.h"

namespace vfm
{

/// Of the trilinear hex from the quad a to the quad b, by Gauss's rule of 2x2x2 points (exact). Corners in VTK's order.
inline double VolumeBetween(const std::array<Vector3, 4>& a, const std::array<Vector3, 4>& b)
{
  const double low = 0.5 - 0.5 / std::sqrt(3.0);
  double volume = 0.0;
  for (int g = 0; g < 8; ++g)
  {
    const double r = g & 1 ? 1.0 - low : low, s = g & 2 ? 1.0 - low : low,
                 t = g & 4 ? 1.0 - low : low;
    Vector3 dr{}, ds{}, dt{};
    const double shape[4] = { (1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s };
    const double byR[4] = { s - 1, 1 - s, s, -s }, byS[4] = { r - 1, -r, r, 1 - r };
    for (int c = 0; c < 4; ++c)
    {
      const Vector3 x = (1.0 - t) * a[c] + t * b[c];
      dr = dr + byR[c] * x;
      ds = ds + byS[c] * x;
      dt = dt + shape[c] * (b[c] - a[c]);
    }
    volume += Dot(dr, Cross(ds, dt)) / 8.0;
  }
  return volume;
}

} // namespace vfm
