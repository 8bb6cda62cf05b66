/**
 * CellOverlaps: the cells of a grid that the cells of another grid of the same domain overlap.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// The cells [Begin, End) of an axis that another cell overlaps.
struct CellRange
{
  Index Begin, End;
};

/// For some consecutive cells of one grid along an axis, the cells of another grid that each of
/// them overlaps, and the share of its width that each takes.
class AxisOverlaps
{
public:
  /// @param first the first of the consecutive cells
  explicit AxisOverlaps(Index first = 0) : First(first) {}

  /// Adds the next cell.
  /// @param begin first cell that it overlaps; shares: of that cell and of those after it
  void Add(Index begin, const std::vector<double>& shares);

  Index Lower() const { return this->First; }
  Index Upper() const { return this->First + static_cast<Index>(this->Begins.size()); }
  /// Returns the cells that a cell overlaps.
  CellRange Of(Index cell) const
  {
    const std::size_t c = cell - this->First;
    return { this->Begins[c], this->Begins[c] + this->Offsets[c + 1] - this->Offsets[c] };
  }
  ///@{ Return the end of the cells that lie before a node entirely, or at least in part.
  Index EndWithin(Index node) const;
  Index EndBefore(Index node) const;
  ///@}
  /// Returns the part of the width of a cell that is in a cell which it overlaps.
  double Share(Index cell, Index overlapped) const
  {
    const std::size_t c = cell - this->First;
    return this->Shares[this->Offsets[c] + overlapped - this->Begins[c]];
  }

private:
  Index First;
  std::vector<Index> Begins, Offsets{ 0 };
  std::vector<double> Shares;
};

/// Overlaps along each axis.
using CellOverlaps = std::array<AxisOverlaps, 3>;

/// Returns the box of cells that a box of other cells overlaps.
IndexBox Overlapped(const CellOverlaps& overlaps, const IndexBox& cells);

/// Finds the overlaps of cells that consist of 2^halvings cells along each axis.
/// @param grid,coarse CoarsenGrid(grid, halvings, g) for any g
/// @param cells cells of the coarse grid
CellOverlaps OverlapsOfBlocks(
  const CartesianGrid& grid, int halvings, const CartesianGrid& coarse, const IndexBox& cells);

/// Finds the overlaps of cells of any width, in a fixed order.
/// @param from,to nodes of both grids; their ends are equal
/// @param cells cells of `to`
CellOverlaps FindOverlaps(const std::array<std::vector<double>, 3>& from,
  const std::array<std::vector<double>, 3>& to, const IndexBox& cells);

/// Returns round(length / width), at least 1: the number of cells of equal width along an axis.
Index CountEqualCells(double length, double width);

/// Returns the nodes of round(length / width) cells of equal width in place of other cells, at
/// least one. If the cells that they replace have equal widths, within 1e-3, nodes that should be
/// equal are so exactly.
std::vector<double> ReplaceNodes(const std::vector<double>& nodes, double width);

} // namespace vfm
