/**
 * UntangleEnergy: the energy of HexEnergy, extended to inverted hexes. The determinant d of a
 * corner, in cell volumes, is replaced by
 *
 *   chi(d) = (d + sqrt(d^2 + eps^2)) / 2,
 *
 * which is positive everywhere and tends to max(d, 0) as eps tends to 0. Minimising this energy
 * untangles the hexes (Garanzha et al. 2021).
 */
#pragma once

#include "Smoothing/ElementEnergy.h"

namespace vfm
{

/// Energy of hexes that may be inverted; never InvalidEnergy. Evaluation is thread safe.
class UntangleEnergy : public ElementEnergy
{
public:
  /// Sets eps, in cell volumes.
  void SetRegularisation(double eps) { this->Eps = eps; }
  double Evaluate(const ActiveMesh& mesh, int point, const Vector3& x,
    const SmoothingStage& stage) const override;
  Derivatives Differentiate(
    const ActiveMesh& mesh, int point, const SmoothingStage& stage) const override;

private:
  double Eps = 1.0;
};

} // namespace vfm
