/**
 * FeatureStarts: sorts all compositions of seed surfaces by approximate residuals, to select the
 * models that are fitted.
 */
#pragma once

#include "SharpFeatures/PackedCells.h"

namespace vfm
{

struct FeatureStart
{
  double Residual; ///< rough
  FeatureModel Model;
};

/// Models made of seed surfaces. Keeps references to the seeds and the cells.
class FeatureStarts
{
public:
  FeatureStarts(const std::vector<LocalQuadric>& seeds, const PackedCells& cells);

  /// Returns the best models made of `count` of the seeds, in all compositions, by rough residual.
  /// Where several surfaces cut a cell, the share inside all of them is taken as the product of the
  /// shares inside each.
  /// @param most  largest number of models returned
  std::vector<FeatureStart> Best(int count, std::size_t most) const;

private:
  const std::vector<LocalQuadric>& Seeds;
  const PackedCells& Cells;
  std::vector<std::vector<std::array<double, 4>>> Inside; ///< share of each cell inside each seed
};

} // namespace vfm
