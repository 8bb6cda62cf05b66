/**
 * The energy of HexEnergy carried on to inverted hexes: the determinant d of a corner (in cell volumes) is replaced by
 *   chi(d) = (d + sqrt(d^2 + eps^2)) / 2,
 * which is positive everywhere and tends to d as eps goes to 0. Minimising it untangles (Garanzha et al. 2021).
 */
#pragma once

#include "Smoothing/ElementEnergy.h"

namespace vfm
{

class UntangleEnergy : public ElementEnergy
{
public:
  /// eps: in cell volumes.
  void SetRegularisation(double eps) { this->Eps = eps; }
  double Evaluate(const ActiveMesh& mesh, int point, const Vector3& x,
    const SmoothingStage& stage) const override;
  Derivatives Differentiate(
    const ActiveMesh& mesh, int point, const SmoothingStage& stage) const override;

private:
  double Eps = 1.0;
};

} // namespace vfm
