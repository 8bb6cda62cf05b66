/**
 * Cells where the mesh has not what the cell has: mixed ones, and those of one material that its elements do not fill. Only near these
 * is state moved between cells.
 */
#pragma once

#include "Transfer/Donors.h"
#include "Transfer/WholeElements.h"

namespace vfm
{

constexpr int FluxLayers = 1; ///< cells around misfits between which contents move
constexpr int DonorLayers =
  3; ///< cells around misfits that have donors: whole elements there are no copies

class MismatchCells
{
public:
  /// donors: with the overlaps of all elements that are no whole cells. isMeshed: by material. Collective.
  MismatchCells(const CartesianGrid& grid, const FractionField& fractions,
    const WholeElements& whole, const DonorTable& donors,
    const std::vector<unsigned char>& isMeshed, const Partition& partition);

  /// Whether a cell is at most so many steps, up to DonorLayers, from a misfit; any rank's. Of cells that far from the rank's own.
  bool IsNear(Index cell, int layers) const { return this->Nearness[cell] > DonorLayers - layers; }

private:
  void MarkAround(std::vector<Index> cells);

  const CartesianGrid& Grid;
  PagedArray<int> Nearness; // DonorLayers + 1 of misfits, one less each step
};

} // namespace vfm
