/**
 * Which models of seeds are worth a fit: all their compositions ranked before any.
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

class FeatureStarts
{
public:
  /// Keeps references.
  FeatureStarts(const std::vector<LocalQuadric>& seeds, const PackedCells& cells);

  /// The best `most` of the models of `count` of the seeds, in all compositions, by rough residuals: where several surfaces cut a cell, what is
  /// inside of all of them is taken for the product of what is inside of each.
  std::vector<FeatureStart> Best(int count, std::size_t most) const;

private:
  const std::vector<LocalQuadric>& Seeds;
  const PackedCells& Cells;
  std::vector<std::vector<std::array<double, 4>>> Inside; ///< shares of cells, by seed
};

} // namespace vfm
