/**
 * Fits crease models to the fractions around a node: Levenberg-Marquardt on the coefficients of their surfaces.
 */
#pragma once

#include "SharpFeatures/PackedCells.h"

namespace vfm
{

/// Weighted root mean square of what a model's fractions are off, over the cells that it or the data cut or that are off.
double ResidualOf(
  const FeatureModel& model, const PackedCells& cells, SharedCells how = SharedCells::Exact);

/// The area of each surface that bounds the second label in the cells, cells^2.
std::array<double, FeatureModel::MaximumSurfaces> AreasOf(
  const FeatureModel& model, const PackedCells& cells);

/// Moves the first `coefficients` (3: planes, 6: quadrics) of each surface towards the least weighted squares, in at most so many iterations.
void FitModel(FeatureModel& model, const PackedCells& cells, int coefficients, int iterations,
  SharedCells how = SharedCells::Exact);

} // namespace vfm
