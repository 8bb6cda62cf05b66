#include "Surfaces/RowSums.h"

#include <algorithm>
#include <limits>

namespace vfm
{
namespace
{

constexpr double NegligiblePart = 1e-12; // fractions so close to 0 or 1 are 0 or 1

/// Returns the integer nearest to a winding number.
double NearestInteger(double winding)
{
  return static_cast<double>(static_cast<Index>(winding + std::copysign(0.5, winding)));
}

} // namespace

double Snapped(double fraction)
{
  return fraction < NegligiblePart ? 0.0 : (fraction > 1.0 - NegligiblePart ? 1.0 : fraction);
}

CellSpan FindCells(const std::vector<double>& nodes, const Interval& interval)
{
  const Index count = static_cast<Index>(nodes.size());
  const Index first =
    std::upper_bound(nodes.begin(), nodes.end(), interval.Low) - nodes.begin() - 1;
  Index last = first; // most intervals meet few cells
  while (last + 1 < count && nodes[last + 1] < interval.High)
  {
    ++last;
  }
  return { first, first >= 0 && nodes[first] == interval.High ? first - 1 : last };
}

RowSums::RowSums(const std::vector<double>& nodes, Index first) :
  Nodes(nodes), First(first), Cells(nodes.size() - first)
{
}

void RowSums::AddPiece(const CutPolygon& piece, Index cell, bool isCut)
{
  const bool isBeyond = cell + 1 == static_cast<Index>(this->Nodes.size());
  const double start = this->Nodes[cell];
  const double width = isBeyond ? 1.0 : this->Nodes[cell + 1] - start;
  const Vector3& a = piece.Corners[0];
  const double depth = (a[0] - start) / width;
  double area = 0.0, volume = 0.0;
  for (int i = 1; i + 1 < piece.Size; ++i)
  {
    const Vector3 &b = piece.Corners[i], &c = piece.Corners[i + 1];
    const double part = 0.5 * ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]));
    area += part;
    volume += part * (depth + (b[0] - start) / width + (c[0] - start) / width) / 3.0;
  }
  Cell& sums = this->Cells[cell - this->First];
  sums.Area += area;
  sums.Volume += isCut ? volume : 0.0;
  sums.IsCut = sums.IsCut || isCut;
}

void RowSums::Add(const CutPolygon& polygon)
{
  const Interval extent = polygon.Extent(0);
  const CellSpan cells = FindCells(this->Nodes, extent);
  if (std::max(cells.First, cells.Last) < this->First)
  {
    return;
  }
  this->IsEmpty = false;
  if (cells.First >= cells.Last) // in one cell, or in the plane below a cell
  {
    this->AddPiece(polygon, cells.First, cells.First == cells.Last);
    return;
  }
  const Index beyond = static_cast<Index>(this->Nodes.size()) - 1;
  for (Index i = std::max(cells.First, this->First); i <= cells.Last; ++i)
  {
    const double high = i < beyond ? this->Nodes[i + 1] : std::numeric_limits<double>::infinity();
    this->AddPiece(CutBetween(polygon, 0, { this->Nodes[i], high }), i, true);
  }
}

void RowSums::Finish(Index count, double* fractions)
{
  if (this->IsEmpty)
  {
    std::fill_n(fractions, count, 0.0);
    return;
  }
  double winding = 0.0; // mean over the upper end of the cell
  for (Index i = static_cast<Index>(this->Cells.size()) - 1; i >= 0; --i)
  {
    Cell& cell = this->Cells[i];
    winding = cell.IsCut ? winding : NearestInteger(winding);
    if (i < count)
    {
      fractions[i] = Snapped(winding + cell.Volume);
    }
    winding += cell.Area;
    cell = Cell();
  }
  this->IsEmpty = true;
}

} // namespace vfm
