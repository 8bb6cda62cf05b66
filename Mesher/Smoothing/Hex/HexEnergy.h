/**
 * HexEnergy: the barrier energy of hexes.
 *
 *   E = sum over hex corners [ (s* / SJ)^p + omega ((tr T^T T) / 3)^(3/2) / det T ]
 *     + sum over hex edge ends (l* / |e|)^8
 *
 * SJ is the scaled Jacobian of the corner, its determinant over the product of its edge lengths. T
 * maps the corner of the grid cell to the hex corner; T = 1 in an undeformed cell, which may be a
 * box. |e| is in widths of the cell along that edge. All three terms grow without bound as a
 * corner degenerates, so corners stay valid in a descent that starts valid. Between the corners,
 * Smoother keeps the coefficients positive (HexCoefficients.h). After Garanzha et al. (2021) and
 * Knupp (2001).
 *
 * As functions of one point, each corner determinant is affine and each squared edge length
 * quadratic, so gradient and Hessian have closed forms. Eight hexes at the point are computed at
 * once in floats. Near inverted corners, where floats are not accurate enough, four at once are
 * computed in doubles. Differences of coordinates are always taken in doubles, and a position is
 * accepted only if doubles would accept it too.
 */
#pragma once

#include "Base/Options.h"
#include "Smoothing/ElementEnergy.h"
#include "Smoothing/Hex/PositiveHexes.h"

namespace vfm
{

/// Returns the target of HexEnergy that matches the options.
/// @param materials  number of materials in the grid
double TargetJacobian(const MeshSettings& options, int materials);
/// Returns the stages of smoothing of hexes.
const SmoothingRamp& HexRamp();

/// Barrier energy of valid hexes. The file comment gives the formula. Thread safe.
class HexEnergy : public ElementEnergy
{
public:
  /// @param targetScaledJacobian  s*
  explicit HexEnergy(double targetScaledJacobian) : Target(targetScaledJacobian) {}
  double Evaluate(const ActiveMesh& mesh, int point, const Vector3& x,
    const SmoothingStage& stage) const override;
  Derivatives Differentiate(
    const ActiveMesh& mesh, int point, const SmoothingStage& stage) const override;
  bool MarkLost(const ActiveMesh& mesh, Runtime& runtime,
    const std::vector<unsigned char>& returned, const std::vector<unsigned char>& where,
    std::vector<unsigned char>& points) const override
  {
    return MarkSmallCoefficients(mesh, runtime, returned, where, points);
  }
  bool KeepsAt(const ActiveMesh& mesh, int point, const Vector3& x) const override
  {
    return KeepPositiveCoefficients(mesh, point, x);
  }

private:
  double Target;
};

} // namespace vfm
