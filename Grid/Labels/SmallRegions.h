/**
 * SmallRegions: assigns small regions to the material around them. A region is a face-connected set
 * of cells of one material, or of void.
 */
#pragma once

#include "Base/Partition.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Numbers over all ranks.
struct RemovedRegions
{
  Index Regions = 0; ///< regions whose material changed
  Index Cells = 0;   ///< cells in these regions
};

/// Removes the regions of fewer than minimumCells cells, as AssignMaterials labels them. The
/// smallest region comes first, on a tie the region with the lowest cell. It gets the material, or
/// void, with which it shares the most faces, on a tie the smaller number. It is then united with
/// the regions of that material that it touches. This is repeated while the union is too small. A
/// region that fills the entire domain stays.
///
/// The fraction of the old material goes to the new one in the cells of a removed region, and in
/// each of the 26 cells around them that has another label. If that would change the label of a
/// cell around, it goes to the label of that cell. So no other label changes, and volumes follow.
/// @param[in,out] fractions  valid in all cells of the local box, before and after
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks.
RemovedRegions RemoveSmallRegions(const CartesianGrid& grid, Index minimumCells, double isoValue,
  const Partition& partition, FractionField& fractions);

} // namespace vfm
