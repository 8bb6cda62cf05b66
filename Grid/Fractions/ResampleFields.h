/**
 * ResampleFields: fractions on other cells of the same domain, by exact overlap.
 *
 * The fraction of a material in a new cell is the sum over the old cells of its fraction there
 * times the share of the new cell that they overlap, in a fixed order. So the volume of each
 * material stays, and results are bitwise identical on any number of ranks and threads.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/CellOverlaps.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Returns the means of fractions over the cells of a box. Cells of one label are handled in runs.
/// @param grid,fractions must contain all cells that the box overlaps
/// @param overlaps of the cells of the box
/// @param to grid whose local box contains the box
/// @return field of the local box of `to`; cells outside the box are void
FractionField MeanFractions(const CartesianGrid& grid, const FractionField& fractions,
  const CellOverlaps& overlaps, const CartesianGrid& to, const IndexBox& box, Runtime& runtime);

/// Returns the same for few cells per new cell, with plain sums.
FractionField MeanOfBlocks(const CartesianGrid& grid, const FractionField& fractions,
  const CellOverlaps& overlaps, const CartesianGrid& to, const IndexBox& box, Runtime& runtime);

/// Returns the new cells of a rank: the blocks of cells whose centre lies in the old cells that it
/// owns. The last block along an axis may have fewer cells.
/// @param from,to nodes of the old and of the new cells
/// @param block number of cells of a block along each axis
IndexBox CellsOfOwner(const std::array<std::vector<double>, 3>& from,
  const std::array<std::vector<double>, 3>& to, Index block, const IndexBox& owned);

/// A grid and the fractions of its cells.
struct ResampledFields
{
  CartesianGrid Grid;
  FractionField Fractions;
};

/// Returns fractions on other cells of a domain, which does not repeat.
/// @param grid,fractions with GhostLayers layers of ghost cells
/// @param nodes nodes of the new cells, from the first to the last node of the grid along each axis
/// @param block ranks own whole blocks of so many cells along each axis
/// @return cells that a rank owns (CellsOfOwner), with GhostLayers layers of ghost cells
/// @pre Collective.
ResampledFields ResampleFields(const CartesianGrid& grid, const FractionField& fractions,
  const std::array<std::vector<double>, 3>& nodes, Index block, Runtime& runtime);

} // namespace vfm
