/**
 * CellDivision: into how many equal parts the cells of a grid are cut along each axis, the same number in all cells of a
 * layer across the axis, so that the parts are cells of a grid too.
 */
#pragma once

#include "Base/IndexBox.h"

namespace vfm
{

class CellDivision
{
public:
  /// No cell is cut, of any grid.
  CellDivision() = default;
  /// parts: of each layer of cells along each axis, >= 1.
  explicit CellDivision(const std::array<std::vector<Index>, 3>& parts);
  /// All cells of a grid in so many along each axis.
  CellDivision(const Index3& cells, Index parts);

  /// Whether no cell is cut.
  bool IsNone() const { return this->First[0].empty(); }
  /// Of a cell, along each axis.
  Index3 Parts(const Index3& cell) const;
  /// The parts of the cells of a box.
  IndexBox Divide(const IndexBox& box) const;
  /// The coordinates of the nodes of the parts; those of the cells stay, bit for bit.
  std::array<std::vector<double>, 3> Divide(std::array<std::vector<double>, 3> coordinates) const;
  /// The cell that a part is of.
  Index3 ParentOf(const Index3& part) const;

  /// The same of the cells halved so many times along each axis.
  CellDivision OfHalves(int times) const;

private:
  std::array<std::vector<Index>, 3> First; // part of each layer, and the end; empty: none is cut
};

/// Nodes that cut each width in so many equal parts.
std::vector<double> DivideWidths(const std::vector<double>& nodes, const std::vector<Index>& parts);

/// The division into the fewest cells of which none is wider along one axis than a number, > 1, times its width along
/// another (to a thousandth). The aspect ratio of a cell is the larger where the widths of the layers that cross in it differ more,
/// and each layer along x crosses each along y and z. So the narrowest layer of the other two axes bounds every layer:
/// each is cut in as many parts as that asks for, again while that makes narrower ones. Parts only grow, and never past those of
/// any other division that serves, so the least that serves comes out. Throws InputError when 64-bit ids could not number the nodes.
CellDivision DivideLongCells(
  const std::array<std::vector<double>, 3>& coordinates, double maximumAspectRatio);

} // namespace vfm
