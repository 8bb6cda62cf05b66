#include "Fractions/Plic.h"

#include <cmath>

namespace vfm
{
namespace
{

double Cube(double x)
{
  return x > 0.0 ? x * x * x : 0.0;
}

/// Returns the volume of the unit cube [0,1]^3 where m.x < alpha, with m >= 0 ascending and
/// of sum 1, and alpha <= 1/2. The cases avoid cancellation of terms that a small component
/// of m makes large.
double VolumeOfCorner(const Vector3& m, double alpha)
{
  if (alpha < m[0])
  {
    return Cube(alpha) / (6.0 * m[0] * m[1] * m[2]);
  }
  if (alpha < m[0] + m[1])
  {
    const double prism = 3.0 * alpha * (alpha - m[0]) + m[0] * m[0];
    const double beyond = alpha > m[1] ? (Cube(alpha - m[1]) + Cube(alpha - m[2])) / m[0] : 0.0;
    return (prism - beyond) / (6.0 * m[1] * m[2]);
  }
  return (2.0 * alpha - m[0] - m[1]) / (2.0 * m[2]);
}

/// Sets m to the magnitudes of n, ascending and scaled to the sum 1. Returns
/// the sum before scaling.
double Normalise(const Vector3& n, Vector3& m)
{
  m = { { std::fabs(n[0]), std::fabs(n[1]), std::fabs(n[2]) } };
  std::sort(m.begin(), m.end());
  const double size = m[0] + m[1] + m[2];
  for (double& x : m)
  {
    x /= size;
  }
  return size;
}

/// Returns the volume of the unit cube [0,1]^3 where m.x < alpha, for m from Normalise.
double VolumeBelow(const Vector3& m, double alpha)
{
  if (alpha <= 0.0 || alpha >= 1.0)
  {
    return alpha <= 0.0 ? 0.0 : 1.0;
  }
  return alpha <= 0.5 ? VolumeOfCorner(m, alpha) : 1.0 - VolumeOfCorner(m, 1.0 - alpha);
}

} // namespace

double VolumeBelowPlane(const Vector3& n, double d)
{
  Vector3 m;
  const double size = Normalise(n, m);
  return VolumeBelow(m, d / size + 0.5);
}

double PlaneOfVolume(const Vector3& n, double fraction)
{
  Vector3 m;
  const double size = Normalise(n, m);
  double low = 0.0, high = 1.0;
  while (high - low > 1e-12)
  {
    const double middle = 0.5 * (low + high);
    (VolumeBelow(m, middle) < fraction ? low : high) = middle;
  }
  return (0.5 * (low + high) - 0.5) * size;
}

} // namespace vfm
