/**
 * ScaledCells: the cells of a grid in grid coordinates (Interface.h).
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// Centres and widths of cells in grid coordinates. The grid must outlive it.
class ScaledCells
{
public:
  explicit ScaledCells(const CartesianGrid& grid) : Grid(grid), Scale(1.0 / grid.MeanWidth()) {}

  Vector3 Centre(const Index3& p) const
  {
    Vector3 c;
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>& x = this->Grid.Coordinates(a);
      c[a] = (0.5 * (x[p[a]] + x[p[a] + 1]) - x[0]) * this->Scale;
    }
    return c;
  }
  Vector3 Widths(const Index3& p) const
  {
    return { { this->Grid.Width(0, p[0]) * this->Scale, this->Grid.Width(1, p[1]) * this->Scale,
      this->Grid.Width(2, p[2]) * this->Scale } };
  }

  const CartesianGrid& Grid;

private:
  double Scale;
};

} // namespace vfm
