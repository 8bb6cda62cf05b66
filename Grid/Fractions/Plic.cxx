#include "Fractions/Plic.h"

#include <cmath>

namespace vfm
{
namespace
{

// PlaneOf begins its bisection in an interval of this width, found by Newton's method.
constexpr double NarrowWidth = 0x1p-36;
constexpr double SafeDistance = 1e-13; // of volumes at its ends, above their rounding
constexpr int NewtonSteps = 12;
constexpr double NewtonIsGood = 1e-8; // step after which the error is below rounding

double Cube(double x)
{
  return x > 0.0 ? x * x * x : 0.0;
}

double Square(double x)
{
  return x > 0.0 ? x * x : 0.0;
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

/// Returns the derivative of VolumeOfCorner by alpha.
double SlopeOfCorner(const Vector3& m, double alpha)
{
  if (alpha < m[0])
  {
    return Square(alpha) / (2.0 * m[0] * m[1] * m[2]);
  }
  if (alpha < m[0] + m[1])
  {
    const double beyond = alpha > m[1] ? (Square(alpha - m[1]) + Square(alpha - m[2])) / m[0] : 0.0;
    return (2.0 * alpha - m[0] - beyond) / (2.0 * m[1] * m[2]);
  }
  return 1.0 / m[2];
}

} // namespace

CellBelowPlanes::CellBelowPlanes(const Vector3& n) :
  M{ { std::fabs(n[0]), std::fabs(n[1]), std::fabs(n[2]) } }
{
  std::sort(this->M.begin(), this->M.end());
  this->Size = this->M[0] + this->M[1] + this->M[2];
  for (double& m : this->M)
  {
    m /= this->Size;
  }
}

/// Returns the volume of the unit cube [0,1]^3 where M.x < alpha.
double CellBelowPlanes::VolumeAt(double alpha) const
{
  if (alpha <= 0.0 || alpha >= 1.0)
  {
    return alpha <= 0.0 ? 0.0 : 1.0;
  }
  return alpha <= 0.5 ? VolumeOfCorner(this->M, alpha) : 1.0 - VolumeOfCorner(this->M, 1.0 - alpha);
}

double CellBelowPlanes::Volume(double d) const
{
  return this->VolumeAt(d / this->Size + 0.5);
}

double CellBelowPlanes::Slope(double d) const
{
  const double alpha = 0.5 - std::fabs(d) / this->Size;
  return alpha > 0.0 ? SlopeOfCorner(this->M, alpha) / this->Size : 0.0;
}

/// Narrows [0, 1] to the interval that a bisection for a fraction reaches after 36 steps, if it is
/// clear in spite of rounding.
void CellBelowPlanes::Narrow(double fraction, double& low, double& high) const
{
  const double part = std::min(fraction, 1.0 - fraction);
  double alpha = 0.5; // Newton's method comes from above, as the slope grows up to 1/2
  double step = 1.0;
  for (int i = 0; i < NewtonSteps && alpha > 0.0 && step > NewtonIsGood; ++i)
  {
    step = (VolumeOfCorner(this->M, alpha) - part) / SlopeOfCorner(this->M, alpha);
    alpha -= step;
  }
  const double place = std::floor((fraction > 0.5 ? 1.0 - alpha : alpha) / NarrowWidth);
  const double from = place * NarrowWidth, to = (place + 1.0) * NarrowWidth;
  if (this->VolumeAt(from) < fraction - SafeDistance &&
    this->VolumeAt(to) > fraction + SafeDistance)
  {
    low = from;
    high = to;
  }
}

double CellBelowPlanes::PlaneOf(double fraction) const
{
  double low = 0.0, high = 1.0;
  this->Narrow(fraction, low, high);
  while (high - low > 1e-12)
  {
    const double middle = 0.5 * (low + high);
    (this->VolumeAt(middle) < fraction ? low : high) = middle;
  }
  return (0.5 * (low + high) - 0.5) * this->Size;
}

} // namespace vfm
