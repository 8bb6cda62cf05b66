/**
 * LayerFit: fits a half-space, or the layer between two parallel planes, to the fractions of a cell
 * and of the cells around it.
 *
 * Lengths are in the frame of the cell, the unit cube centred at the origin. The cells around it
 * have their own widths, which may vary in any way. Fits of a half-space start at the gradient of
 * the fractions, fits of a layer at their moments of inertia. Gauss-Newton steps minimise the
 * squared errors of the fractions and keep the volume in the cell, so flat interfaces are found to
 * rounding (LVIRA: Pilliod and Puckett, J. Comput. Phys. 199 (2004) 465-502).
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// A cell and its filled fraction.
struct FractionSample
{
  Vector3 Centre, Size;
  double Value;  ///< 0 to 1
  double Weight; ///< >= 0
};

/// Points with Lower < Normal . x < Upper. Lower is -infinity for a half-space.
struct Layer
{
  Vector3 Normal; ///< unit
  double Lower, Upper;
};

/// Returns the fraction of a box inside a layer.
double FractionInLayer(const Layer& layer, const Vector3& centre, const Vector3& size);

/// Result of a fit.
struct LayerFit
{
  bool IsFound = false;
  Layer Region;
  double Error = 1.0; ///< weighted root mean square of the errors of the fractions
};

/// Fits a half-space. It is not found if the fractions show no direction.
/// @param samples  the cell itself first, with 0 < Value < 1
LayerFit FitHalfSpace(const std::vector<FractionSample>& samples);

/// Fits a film thinner than about 1.5 cells, from the same samples.
LayerFit FitFilm(const std::vector<FractionSample>& samples);

/// Returns whether the filled volume extends along a line only, as a thread does.
bool IsAlongLine(const std::vector<FractionSample>& samples);

} // namespace vfm
