/**
 * CellDivision: divides the cells of a grid into equal parts along each axis. Cells of one layer
 * across an axis all have the same number of parts, so the parts are cells of a grid too.
 */
#pragma once

#include "Base/IndexBox.h"

namespace vfm
{

/// Number of parts of each layer of cells along each axis. It does not change after construction.
class CellDivision
{
public:
  /// Divides no cell, on any grid.
  CellDivision() = default;
  /// @param parts  number of parts of each layer of cells along each axis, >= 1
  explicit CellDivision(const std::array<std::vector<Index>, 3>& parts);
  /// Divides all cells of a grid of cells[axis] cells into the same number of
  /// parts along each axis.
  CellDivision(const Index3& cells, Index parts);

  /// Returns whether no cell is divided.
  bool IsNone() const { return this->First[0].empty(); }
  /// Returns the number of parts of a cell along each axis.
  Index3 Parts(const Index3& cell) const;
  /// Returns the box of the parts of the cells of a box.
  IndexBox Divide(const IndexBox& box) const;
  /// Returns the node coordinates of the parts. Existing nodes stay bitwise identical.
  std::array<std::vector<double>, 3> Divide(std::array<std::vector<double>, 3> coordinates) const;
  /// Returns the cell that contains a part.
  Index3 ParentOf(const Index3& part) const;

  /// Returns the division of the cells halved `times` times along each axis; each gets as many
  /// parts as its original cell.
  CellDivision OfHalves(int times) const;

private:
  // First part of each layer, and the end; empty: no cell is divided.
  std::array<std::vector<Index>, 3> First;
};

/// Returns nodes that divide each width into a number of equal parts.
std::vector<double> DivideWidths(const std::vector<double>& nodes, const std::vector<Index>& parts);

/// Returns the division into the fewest cells whose aspect ratio is at most a
/// maximum, to a thousandth.
///
/// Each layer along an axis crosses each layer along the other two, so the narrowest layer of these
/// bounds its width. Each layer is divided into the fewest parts that this bound requires. This is
/// repeated while it makes narrower layers. Numbers of parts only grow, and never exceed the
/// numbers of any other valid division, so the result is the smallest one.
/// @param coordinates  node coordinates of the whole grid
/// @param maximumAspectRatio  > 1
/// @throws InputError  if 64-bit ids cannot number the nodes
CellDivision DivideLongCells(
  const std::array<std::vector<double>, 3>& coordinates, double maximumAspectRatio);

} // namespace vfm
