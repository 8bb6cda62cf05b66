/**
 * FeatureFit: fits sharp-feature models to the fractions around a node, by the Levenberg-Marquardt
 * method on the coefficients of their surfaces.
 */
#pragma once

#include "SharpFeatures/PackedCells.h"

namespace vfm
{

/// Returns the weighted root mean square error of the fractions of a model. Cells count if the
/// model or the data cut them, or if both differ.
double ResidualOf(
  const FeatureModel& model, const PackedCells& cells, SharedCells how = SharedCells::Exact);

/// Returns the area of the part of each surface that bounds the second label in the cells, cells^2.
std::array<double, FeatureModel::MaximumSurfaces> AreasOf(
  const FeatureModel& model, const PackedCells& cells);

/// Moves the surfaces of a model to reduce the weighted squares of its errors. Each accepted
/// iteration reduces the cost.
/// @param[in,out] model  start and result
/// @param coefficients  number of leading coefficients of each surface that change: 3 for
///   planes, 6 for quadrics
/// @param iterations  largest number of iterations
/// @param how  treatment of cells that several surfaces cut
void FitModel(FeatureModel& model, const PackedCells& cells, int coefficients, int iterations,
  SharedCells how = SharedCells::Exact);

} // namespace vfm
