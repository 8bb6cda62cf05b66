/**
 * WideContents: the state of each material in cells that replace those of the input (option
 * CellWidth), by exact overlap.
 */
#pragma once

#include "Base/Runtime.h"
#include "State/ConservedCells.h"
#include "State/MeanContents.h"

namespace vfm
{

/// Means over the cells of another donor grid. The sums of contents are those of that grid.
class WideContents : public DonorCells
{
public:
  /// @param read holds all cells that the local box of the grid overlaps
  /// @param grid grid of the new cells, of level 0
  WideContents(const DonorCells& read, const CartesianGrid& grid, Runtime& runtime);

  const CartesianGrid& GetGrid() const override { return this->Grid; }
  int GetLevel() const override { return 0; }
  const FractionField& GetFractions() const override { return this->Fractions; }
  const InputContents& GetContents() const override { return this->Contents; }

  void Read(const Index3& cell, int material, double* values) const override;

private:
  const InputContents Contents;
  const CartesianGrid Grid;
  const FractionField Fractions;
  MeanContents Means; // numbers are indices in the local box
};

} // namespace vfm
