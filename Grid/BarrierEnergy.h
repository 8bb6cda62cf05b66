/**
 * The energy that smoothing minimises, as a function of one point, with its exact derivatives.
 *
 *   E = sum over hex corners [ (s* / SJ)^p + omega ((tr T^T T) / 3)^(3/2) / det T ]
 *     + sum over hex edge ends (l* / |e|)^8
 *
 * SJ is the scaled Jacobian of the corner (its determinant over the product of its edge lengths), T maps
 * the corner of the grid cell to the hex corner (so T = 1 in an undeformed cell, which may be a box), |e|
 * is in widths of the cell along that edge. All three grow without bound as a corner degenerates, so a
 * descent that starts valid stays valid. After Garanzha et al. (2021), Knupp (2001).
 *
 * In one point each corner determinant is affine and each squared edge quadratic, so gradient and Hessian are
 * closed form. The four corners that a point of a hex takes part in are computed side by side.
 */
#pragma once

#include "ActiveMesh.h"

namespace vfm
{

struct BarrierWeights
{
  int HalfPower;       ///< p / 2, a power of two
  double Target;       ///< s*
  double Shape;        ///< omega
  double ShortestEdge; ///< l*, in cell widths
};

/// Derivatives of an energy in one point: value, gradient, Hessian (xx yy zz xy xz yz).
struct Derivatives
{
  double Value = 0.0;
  Vector3 Gradient{ { 0.0, 0.0, 0.0 } };
  std::array<double, 6> Hessian{ { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
};

/// Returned by EvaluateBarrier where a corner determinant is not positive.
constexpr double InvalidEnergy = 1e300;

/// Energy of the hexes at an active point when it stands at x.
double EvaluateBarrier(
  const ActiveMesh& mesh, int point, const Vector3& x, const BarrierWeights& weights);

/// The same at its present place, with derivatives.
Derivatives DifferentiateBarrier(const ActiveMesh& mesh, int point, const BarrierWeights& weights);

} // namespace vfm
