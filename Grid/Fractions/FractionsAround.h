/**
 * FractionsAround: copies of the fractions of some cells and of the 26 cells around each of them,
 * for several visits.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// Fractions of cells and of those around them. The parts of three cells in a row are beside each
/// other, so that a visit reads nine pieces of memory, without a search.
class FractionsAround
{
public:
  /// @param cells  linear indices, ascending; the cells around each must be in the local box or
  ///   outside the domain
  FractionsAround(
    const CartesianGrid& grid, const FractionField& fractions, const std::vector<Index>& cells);

  /// Calls visit(n, material, fraction) for the parts of the 27 cells around the c-th cell
  /// (CellAround). Cells outside the domain have the parts of the nearest cell in it.
  template <class Visitor>
  void ForParts(Index c, const Visitor& visit) const
  {
    for (int row = 0; row < 9; ++row)
    {
      const Index* offset = this->Offset.data() + this->First[9 * c + row];
      for (int step = 0; step < 3; ++step)
      {
        for (Index p = offset[step]; p < offset[step + 1]; ++p)
        {
          visit(3 * row + step, this->Parts[p].Material, this->Parts[p].Fraction);
        }
      }
    }
  }

private:
  void CopyParts(
    const CartesianGrid& grid, const FractionField& fractions, PagedArray<int>& numbers);

  std::vector<int> First;    // by cell and row: number of the first of three cells
  std::vector<Index> Offset; // by number
  std::vector<FractionField::Part> Parts;
};

} // namespace vfm
