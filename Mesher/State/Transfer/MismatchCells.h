/**
 * MismatchCells: the cells whose contents differ from the elements in them. These are mixed cells,
 * and pure cells that elements of their material do not fill. State moves between cells only near
 * mismatch cells.
 */
#pragma once

#include "State/Transfer/Donors.h"
#include "State/Transfer/WholeElements.h"

namespace vfm
{

/// Layers of cells around mismatch cells between which contents move.
constexpr int FluxLayers = 1;
/// Layers of cells around mismatch cells that have donors. Whole elements there take state from
/// donors; elsewhere they copy it from their cells.
constexpr int DonorLayers = 3;

/// Distances of cells to the nearest mismatch cell. The grid must outlive this object.
class MismatchCells
{
public:
  /// Finds the mismatch cells of all ranks, as far as this rank holds them.
  /// @param donors  donors with the overlaps of all elements that are not whole cells
  /// @param isMeshed  one flag per material
  /// @pre Collective among peers.
  MismatchCells(const CartesianGrid& grid, const FractionField& fractions,
    const WholeElements& whole, const DonorTable& donors,
    const std::vector<unsigned char>& isMeshed, const Partition& partition);

  /// Returns whether a cell is within some layers of a mismatch cell of any rank.
  /// @param cell  linear index of a cell that is at most `layers` cells from the owned cells
  /// @param layers  0 to DonorLayers
  bool IsNear(Index cell, int layers) const { return this->Nearness[cell] > DonorLayers - layers; }

private:
  void MarkAround(std::vector<Index> cells);

  const CartesianGrid& Grid;
  // DonorLayers + 1 in mismatch cells, one less per layer around them, 0 elsewhere.
  PagedArray<int> Nearness;
};

} // namespace vfm
