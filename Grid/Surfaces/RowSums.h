/**
 * RowSums: the part of a solid in each cell of a row along x, from the pieces of its surface there.
 *
 * By the divergence theorem, a piece that faces +x adds to each cell the volume between the lower
 * end of the cell and the piece, and its shadow in all cells before its own. A piece that faces -x
 * subtracts them. So each piece is stored once, in its own cell, and one pass from the upper end
 * of the row adds the shadows.
 */
#pragma once

#include "Surfaces/CutPolygon.h"

#include <vector>

namespace vfm
{

/// Returns a fraction as 0 or 1 if it is closer to it than rounding can be.
double Snapped(double fraction);

/// Range of the cells first <= i <= last.
struct CellSpan
{
  Index First, Last;
};

/// Returns the cells whose interior an interval meets. Cell -1 is below all nodes, cell
/// nodes.size() - 1 above them. If the interval is a single node, First is the cell above it, and
/// the range is empty.
CellSpan FindCells(const std::vector<double>& nodes, const Interval& interval);

/// Sums over the pieces of a surface in one row. Pieces below the first cell count nothing.
class RowSums
{
public:
  /// @param nodes  all nodes of the grid along x; must outlive this object
  /// @param first  first cell of which the fraction is required
  RowSums(const std::vector<double>& nodes, Index first);

  /// Adds a polygon inside the row. Its y and z are relative to the row, from 0 to 1.
  void Add(const CutPolygon& polygon);

  /// Computes the fractions of some cells from the first one, and clears the sums. A cell that no
  /// piece cuts has exactly 0 or 1.
  void Finish(Index count, double* fractions);

private:
  struct Cell
  {
    double Area = 0.0;   // of the projections of pieces to the yz plane, negative if they face -x
    double Volume = 0.0; // between the lower end of the cell and its pieces
    bool IsCut = false;
  };
  void AddPiece(const CutPolygon& piece, Index cell, bool isCut);

  const std::vector<double>& Nodes;
  const Index First;
  std::vector<Cell> Cells; // from First to the cell beyond all nodes
  bool IsEmpty = true;
};

} // namespace vfm
