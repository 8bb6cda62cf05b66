/**
 * Small regions given to what surrounds them. A region is a face-connected piece of cells of one material, or of void.
 */
#pragma once

#include "Base/Partition.h"
#include "Fractions/FractionField.h"

namespace vfm
{

struct RemovedRegions
{
  Index Regions = 0; ///< that have another material now; of all ranks
  Index Cells = 0;   ///< in them
};

/// Removes the regions of fewer than minimumCells cells: of the cells as the fractions label them (AssignMaterials). The smallest
/// first, of equal ones that with the lowest cell, a region gets the material, or void, with which it shares the most faces, of
/// equal ones the smaller number, and is one with the regions of it that it touches; that goes on while the union is too small.
/// A region that fills the whole domain stays.
///
/// In the cells of a removed region, and in those around them (26) that have another label, the fraction of the material that was
/// there goes to the new one; where that would change the label of a cell around, it goes to the cell's own. So no other
/// label changes, and volumes follow. fractions: right in all cells of the local box; so is the result. Every rank learns of all
/// regions. The same on any number of ranks. Collective.
RemovedRegions RemoveSmallRegions(const CartesianGrid& grid, Index minimumCells, double isoValue,
  const Partition& partition, FractionField& fractions);

} // namespace vfm
