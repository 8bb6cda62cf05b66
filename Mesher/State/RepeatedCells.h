/**
 * RepeatedCells: the cells of the donor grid for a transfer of state, in a periodic domain with
 * copies around it (CartesianGrid::Covering).
 */
#pragma once

#include "State/ConservedCells.h"

#include <optional>

namespace vfm
{

/// Grid, fractions and values of the cells of a mesh, which may be periodic. Read() may be called
/// by several threads, for cells that this rank owns.
class RepeatedCells : public StateCellValues
{
public:
  /// @param cells must outlive this object
  /// @param meshed grid that the mesh was made on
  /// @pre Collective
  RepeatedCells(const DonorCells& cells, const CartesianGrid& meshed, Ranks& ranks);

  const CartesianGrid& GetGrid() const
  {
    return this->Copies ? this->Copies->Grid : this->Cells.GetGrid();
  }
  const FractionField& GetFractions() const
  {
    return this->Copies ? this->Copies->Fractions : this->Cells.GetFractions();
  }

  void Read(const Index3& cell, int material, double* values) const override;

private:
  struct Covering
  {
    CartesianGrid Grid;
    FractionField Fractions;
  };

  const DonorCells& Cells;
  std::optional<Covering> Copies; // empty if the domain does not repeat
};

} // namespace vfm
