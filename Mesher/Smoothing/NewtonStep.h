/**
 * NewtonStep: the step of a point that minimises the quadratic model of its energy, and the lengths
 * along it that Smoother tries first.
 */
#pragma once

#include "Base/Vector3.h"
#include "Smoothing/ElementEnergy.h"

#include <Eigen/Eigenvalues>

namespace vfm
{

constexpr double TrustRadius = 0.2; // largest step, in cells
// Multiple of the fall that counts, below which a point is settled.
constexpr double SettledFalls = 4.0;
constexpr double BarrierShare = 0.9; // 1 - 1 / p for the powers of a hard barrier

/// Solves H x = -g by L D L^T, H as xx yy zz xy xz yz; returns whether H is positive definite.
inline bool SolvePositive(const std::array<double, 6>& h, const Vector3& g, Vector3& x)
{
  const double first = 1.0 / h[0], l10 = h[3] * first, l20 = h[4] * first;
  const double d1 = h[1] - l10 * h[3], e = h[5] - l20 * h[3];
  const double second = 1.0 / d1, l21 = e * second;
  const double d2 = h[2] - l20 * h[4] - l21 * e;
  const double y1 = l10 * g[0] - g[1], y2 = l20 * g[0] - g[2] - l21 * y1;
  x[2] = y2 / d2;
  x[1] = y1 * second - l21 * x[2];
  x[0] = -g[0] * first - l10 * x[1] - l20 * x[2];
  return h[0] > 0.0 && d1 > 0.0 && d2 > 0.0;
}

/// Returns -|H|^-1 g.
inline Vector3 SolveIndefinite(const std::array<double, 6>& h, const Vector3& g)
{
  Eigen::Matrix3d H;
  H << h[0], h[3], h[4], h[3], h[1], h[5], h[4], h[5], h[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(H);
  const double floor = 1e-6 * eigen.eigenvalues().cwiseAbs().maxCoeff() + 1e-12;
  const Eigen::Vector3d inverse = eigen.eigenvalues().cwiseAbs().cwiseMax(floor).cwiseInverse();
  const Eigen::Vector3d x = eigen.eigenvectors() *
    (inverse.asDiagonal() *
      (eigen.eigenvectors().transpose() * -Eigen::Vector3d(g[0], g[1], g[2])));
  return { { x[0], x[1], x[2] } };
}

/// Returns the Newton step along the axes that are not held, always a direction of descent.
inline Vector3 SolveNewton(int held, Derivatives& d)
{
  constexpr int RowOf[3][2] = { { 3, 4 }, { 3, 5 }, { 4, 5 } };
  for (int a = 0; a < 3; ++a)
  {
    if (held >> a & 1)
    {
      d.Hessian[a] = 1.0;
      d.Hessian[RowOf[a][0]] = d.Hessian[RowOf[a][1]] = 0.0;
      d.Gradient[a] = 0.0;
    }
  }
  Vector3 step;
  return SolvePositive(d.Hessian, d.Gradient, step) ? step : SolveIndefinite(d.Hessian, d.Gradient);
}

/// Returns the smallest decrease of an energy that marks the neighbours.
inline double FallThatCounts(const SmoothingPace& pace, double energy)
{
  return pace.FallThatCounts + pace.PartThatCounts * energy;
}

/// Returns the multiple of a Newton step that is tried first. A barrier is nearly E = x^-p, on
/// which Newton steps grow x only by the factor 1 + 1 / (p + 1). Newton steps of E^(1/p) have the
/// same direction and are longer by the factor 1 / (1 - (1 - 1 / p) fall / E).
/// @param fall  twice the decrease that the quadratic model predicts. If it is small, the step is
/// not relaxed, because an exact step leaves nothing to do.
inline double FirstFactor(const SmoothingPace& pace, double length, double fall, double energy)
{
  const bool isRelaxed = length < TrustRadius && fall > SettledFalls * FallThatCounts(pace, energy);
  const double left = std::max(1.0 - BarrierShare * fall / energy, 1.0 / pace.LongestStretch);
  return std::max(
    { 1.0, isRelaxed ? pace.Relaxation : 1.0, std::min(1.0 / left, TrustRadius / length) });
}

} // namespace vfm
