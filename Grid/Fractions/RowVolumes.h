/**
 * RowVolumes: exact sums of the volumes of cells along x, found without a visit to each cell.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Base/ExactSum.h"
#include "Base/PortableMath.h"

#include <cmath>
#include <map>

namespace vfm
{

/// Sums of the volumes of cells in a row, in mean cells. Rows of cells with equal widths share
/// their sums. Not thread safe: Start changes the current row.
class RowVolumes
{
public:
  explicit RowVolumes(const CartesianGrid& grid) : Grid(grid), Scale(1.0 / Cube(grid.MeanWidth()))
  {
  }

  double OfCell(const Index3& p) const { return this->Grid.CellVolume(p) * this->Scale; }
  /// Selects row (j, k) of the owned cells.
  void Start(Index j, Index k)
  {
    if (this->Known.size() >= MaximumRows)
    {
      this->Known.clear();
    }
    const auto at = this->Known.try_emplace({ this->Grid.Width(1, j), this->Grid.Width(2, k) });
    this->Row = &at.first->second;
    const IndexBox& box = this->Grid.Owned();
    if (at.second)
    {
      this->Row->resize(1);
      for (Index i = box.Lower[0]; i < box.Upper[0]; ++i)
      {
        ExactSum sum = this->Row->back();
        sum.Add(this->OfCell({ { i, j, k } }));
        this->Row->push_back(sum);
      }
    }
  }
  /// Returns the volume of the owned cells from `first` to before `last` of the selected row.
  ExactSum Of(Index first, Index last) const
  {
    const Index lower = this->Grid.Owned().Lower[0];
    ExactSum sum = (*this->Row)[last - lower];
    sum.Subtract((*this->Row)[first - lower]);
    return sum;
  }

private:
  static constexpr std::size_t MaximumRows = 256;
  const CartesianGrid& Grid;
  double Scale;
  // By widths along y and z: sums of the cells before each cell of the row.
  std::map<std::array<double, 2>, std::vector<ExactSum>> Known;
  std::vector<ExactSum>* Row = nullptr;
};

} // namespace vfm
