/**
 * HexEnergy where interfaces run through several levels: a point may move only as long as the trilinear Jacobian of each hex
 * at it stays positive everywhere, not in the corners alone. Starts between levels are more twisted than those of cells.
 */
#pragma once

#include "Smoothing/HexEnergy.h"

namespace vfm
{

/// The smallest of the 27 Bernstein coefficients of the Jacobian of a trilinear hex, corners by bits: where it is positive the
/// Jacobian is so everywhere (Johnen, Remacle, Geuzaine 2013). In cubed units of the corners.
double SmallestCoefficient(const std::array<Vector3, 8>& corners);

class GuardedHexEnergy : public HexEnergy
{
public:
  using HexEnergy::HexEnergy;
  /// InvalidEnergy also where a hex would get a coefficient that is not positive, unless it has a worse one now.
  double Evaluate(const ActiveMesh& mesh, int point, const Vector3& x,
    const SmoothingStage& stage) const override;
};

} // namespace vfm
