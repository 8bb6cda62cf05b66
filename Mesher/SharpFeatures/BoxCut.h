/**
 * BoxCut: volume of the part of the unit cube centred at 0 that is inside up to three planes, and
 * its derivatives by each plane.
 *
 * Templates take one double or four lanes (Base/Lanes.h).
 */
#pragma once

#include "Base/Clones.h"
#include "Base/Vector3.h"

#include <array>

namespace vfm
{

/// A plane; its inside is Normal . x + Height >= 0. The normal need not be a unit vector; it is
/// nonzero where the plane cuts.
template <class Real>
struct BoxPlaneOf
{
  std::array<Real, 3> Normal;
  Real Height;
};
using BoxPlane = BoxPlaneOf<double>;

/// Derivatives of a volume by a plane: area and first moments of the plane's part of the boundary,
/// divided by |Normal|.
template <class Real>
struct PlaneRatesOf
{
  Real ByHeight;                ///< dVolume / dHeight
  std::array<Real, 3> ByNormal; ///< dVolume / dNormal
};
using PlaneRates = PlaneRatesOf<double>;

template <class Real>
VFM_INLINE Real Magnitude(const Real& a)
{
  return a < 0.0 ? -a : a;
}

/// Returns the largest |Normal . x| in the cube.
template <class Real>
VFM_INLINE Real ReachOf(const BoxPlaneOf<Real>& plane)
{
  return 0.5 *
    (Magnitude(plane.Normal[0]) + Magnitude(plane.Normal[1]) + Magnitude(plane.Normal[2]));
}

/// Area and first moments of a part of a square.
template <class Real>
struct SquarePartOf
{
  Real Area, X, Y;
};
using SquarePart = SquarePartOf<double>;

/// Measures the part of the unit square [0,1]^2 where p x + q y < beta; p, q >= 0.
template <class Real>
VFM_INLINE SquarePartOf<Real> UnderLine(const Real& p, const Real& q, const Real& beta)
{
  // Measures from the nearer of the corners (0,0) and (1,1), with the larger component along y.
  const Real zero{}, rest = p + q - beta;
  const auto isLow = beta <= rest;
  const Real nearer = isLow ? beta : rest, b = nearer < 0.0 ? zero : nearer;
  const Real low = p < q ? p : q, high = (p < q ? q : p) + 1e-300;
  const Real left = b / high;
  // The part is a trapezoid, or a triangle of base b / low.
  const auto isTriangle = b < low;
  const Real base = isTriangle ? b / low : zero;
  const Real right = isTriangle ? zero : (b - low) / high;
  const Real sum = left + right;
  const Real area = 0.5 * (isTriangle ? base * left : sum);
  const Real along = isTriangle ? area * base * (1.0 / 3.0) : (sum + right) * (1.0 / 6.0);
  const Real across =
    isTriangle ? area * left * (1.0 / 3.0) : (sum * sum - left * right) * (1.0 / 6.0);
  const Real x = p < q ? along : across, y = p < q ? across : along;
  return { isLow ? area : 1.0 - area, isLow ? x : 0.5 - area + x, isLow ? y : 0.5 - area + y };
}

/// Returns the volume inside one plane, in closed form: seen along the largest component of the
/// normal, the section is the part of a square between two parallel lines. Volumes are computed as
/// in Plic.h; areas and moments need no polygons.
/// @param[out] rates  derivatives of the volume by the plane
template <class Real>
VFM_INLINE Real CutBox(const BoxPlaneOf<Real>& plane, PlaneRatesOf<Real>& rates)
{
  // Reflects the cube into [0,1]^3, where p . s < alpha with p >= 0. Rotates the axes so that the
  // third has the largest p.
  const std::array<Real, 3>& n = plane.Normal;
  const std::array<Real, 3> p{ { Magnitude(n[0]), Magnitude(n[1]), Magnitude(n[2]) } };
  const auto isY = p[1] >= p[2];
  const auto isX = p[0] >= (isY ? p[1] : p[2]);
  const Real a = isX ? p[1] : (isY ? p[2] : p[0]), b = isX ? p[2] : (isY ? p[0] : p[1]);
  const Real c = (isX ? p[0] : (isY ? p[1] : p[2])) + 1e-300;
  const Real alpha = plane.Height + 0.5 * (a + b + c), inverse = 1.0 / c;
  const SquarePartOf<Real> below = UnderLine(a, b, alpha), above = UnderLine(a, b, alpha - c);
  const Real area = below.Area - above.Area, x = below.X - above.X, y = below.Y - above.Y;
  const Real height = (alpha * area - a * x - b * y) * inverse;
  rates.ByHeight = area * inverse;
  const Real half = 0.5 * area;
  const Real byA = (half - x) * inverse, byB = (half - y) * inverse,
             byC = (half - height) * inverse;
  const std::array<Real, 3> by{ { isX ? byC : (isY ? byB : byA), isX ? byA : (isY ? byC : byB),
    isX ? byB : (isY ? byA : byC) } };
  for (int axis = 0; axis < 3; ++axis)
  {
    rates.ByNormal[axis] = n[axis] < 0.0 ? -by[axis] : by[axis];
  }
  return height + above.Area;
}

/// Returns the volume inside all planes of a mask, by clipping their sections and three
/// faces of the cube.
/// @param mask  bits of two or three planes
/// @param[out] rates  derivatives by each plane of the mask; others are left unchanged
double CutBox(const std::array<BoxPlane, 3>& planes, int mask, std::array<PlaneRates, 3>& rates);

} // namespace vfm
