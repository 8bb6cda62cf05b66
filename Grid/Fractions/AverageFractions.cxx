#include "Fractions/AverageFractions.h"

#include "Fractions/GhostFractions.h"

#include <limits>

namespace vfm
{
namespace
{

/// Shares that a cell takes from the lower and the upper neighbour along an axis.
struct Shares
{
  double Lower, Upper;
};

Shares FindShares(const CartesianGrid& grid, int axis, Index i)
{
  if (i == 0 || i == grid.Global().Upper[axis] - 1)
  {
    return { 0.0, 0.0 };
  }
  const double width = grid.Width(axis, i);
  return { 0.25 * std::min(width, grid.Width(axis, i - 1)) / width,
    0.25 * std::min(width, grid.Width(axis, i + 1)) / width };
}

using Part = FractionField::Part;
using Range = FractionField::Range;

/// Cells of a row in order: of one label, or one cell with a negative label.
struct Run
{
  Index End; // first cell behind the run, from the start of the row
  int Label; // of averages: ~(number of parts) if it is negative
};

/// The averages of a row, and lists of runs for the search of mixed cells.
struct RowOfAverages
{
  std::vector<Run> Runs;
  std::vector<Part> Parts; // of the cells with negative labels
  std::vector<Run> Own, Below, Above;
};

/// Returns the parts of a cell.
/// @param[out] whole  holds the part of a pure cell
Range PartsOf(const FractionField& fractions, Index cell, Part& whole)
{
  if (fractions.IsMixed(cell))
  {
    return fractions.Parts(cell);
  }
  whole = { fractions.Label(cell), 1.0 };
  return { &whole, &whole + 1 };
}

/// Parts of a cell, and the share that another cell takes from it.
struct SharedParts
{
  Range Parts;
  double Share;
};

/// Adds the weighted sum of the parts of some cells, cell by cell, ascending by material.
/// @return number of parts added
template <std::size_t N>
int AddSum(std::array<SharedParts, N> cells, std::vector<Part>& parts)
{
  constexpr int none = std::numeric_limits<int>::max();
  int count = 0;
  for (;; ++count)
  {
    int material = none;
    for (const SharedParts& cell : cells)
    {
      material = cell.Parts.First == cell.Parts.Last
        ? material
        : std::min(material, cell.Parts.First->Material);
    }
    if (material == none)
    {
      return count;
    }
    double sum = 0.0;
    for (SharedParts& cell : cells)
    {
      if (cell.Parts.First != cell.Parts.Last && cell.Parts.First->Material == material)
      {
        sum += cell.Share * (cell.Parts.First++)->Fraction;
      }
    }
    parts.push_back({ material, sum });
  }
}

/// Averages along one axis, row by row.
class RowAverage
{
public:
  RowAverage(const CartesianGrid& grid, const FractionField& from, int axis, const IndexBox& box) :
    Grid(grid), From(from), Axis(axis), Box(box)
  {
    for (Index i = box.Lower[axis]; i < box.Upper[axis]; ++i)
    {
      this->SharesAt.push_back(FindShares(grid, axis, i));
    }
  }

  void AverageRow(Index j, Index k, RowOfAverages& row) const
  {
    row.Runs.clear();
    row.Parts.clear();
    const Index first = this->Grid.Linear({ { this->Box.Lower[0], j, k } });
    const Index count = this->Box.Size(0);
    const Index at = this->Axis == 0 ? 0 : (this->Axis == 1 ? j : k) - this->Box.Lower[this->Axis];
    const auto sharesOf = [&](Index i) { return this->SharesAt[this->Axis == 0 ? i : at]; };
    // Only cells inside of the domain exchange anything along the axis.
    const auto exchanges = [&](Index i) { return sharesOf(i).Lower > 0.0; };
    for (Index i = 0, end = 0; i < count; i = end)
    {
      const bool isInside = exchanges(i);
      for (end = i + 1; end < count && exchanges(end) == isInside;)
      {
        ++end;
      }
      this->AverageRange(first, { { i, end } }, isInside, sharesOf, row);
    }
  }

  void StoreRow(Index j, Index k, const RowOfAverages& averages, FractionField& to) const
  {
    const Part* next = averages.Parts.data();
    FractionField::RowWriter row(to);
    row.Start(this->Grid.Linear({ { this->Box.Lower[0], j, k } }));
    Index begin = 0;
    for (const Run& run : averages.Runs)
    {
      if (run.Label >= 0)
      {
        row.AddLabel(run.Label, run.End - begin);
      }
      else
      {
        row.CopyParts({ next, next + ~run.Label });
        next += ~run.Label;
      }
      begin = run.End;
    }
    row.Finish();
  }

private:
  /// Lists the runs of cells [range[0], range[1]) of a row that starts at cell `first`.
  void ListRuns(Index first, const std::array<Index, 2>& range, std::vector<Run>& runs) const
  {
    runs.clear();
    this->From.VisitRuns(first + range[0], first + range[1],
      [&](Index, Index end, int label) {
        runs.push_back({ end - first, label });
      });
  }

  /// Averages a range of a row in which all cells exchange, or none.
  template <class SharesOf>
  void AverageRange(Index first, const std::array<Index, 2>& range, bool exchanges,
    const SharesOf& sharesOf, RowOfAverages& row) const
  {
    const Index step = this->Grid.Stride(this->Axis);
    this->ListRuns(first, range, row.Own);
    if (exchanges)
    {
      this->ListRuns(first - step, range, row.Below);
      this->ListRuns(first + step, range, row.Above);
    }
    const Run* o = row.Own.data();
    const Run* b = exchanges ? row.Below.data() : o;
    const Run* a = exchanges ? row.Above.data() : o;
    for (Index i = range[0]; i < range[1];)
    {
      const Index end = std::min({ o->End, b->End, a->End });
      const bool isPure = o->Label >= 0 && b->Label == o->Label && a->Label == o->Label;
      if (isPure)
      {
        row.Runs.push_back({ end, o->Label });
      }
      for (; !isPure && i < end; ++i)
      {
        row.Runs.push_back({ i + 1, ~this->Average(first + i, sharesOf(i), row.Parts) });
      }
      i = end;
      o += o->End == end;
      b += b->End == end;
      a += a->End == end;
    }
  }

  /// Adds the parts of a cell and returns their number.
  int Average(Index cell, const Shares& shares, std::vector<Part>& parts) const
  {
    Part own, lower, upper;
    const SharedParts mine{ PartsOf(this->From, cell, own), 1.0 - (shares.Lower + shares.Upper) };
    if (!(shares.Lower > 0.0))
    {
      return AddSum(std::array<SharedParts, 1>{ mine }, parts);
    }
    const Index step = this->Grid.Stride(this->Axis);
    return AddSum(
      std::array<SharedParts, 3>{ mine, { PartsOf(this->From, cell - step, lower), shares.Lower },
        { PartsOf(this->From, cell + step, upper), shares.Upper } },
      parts);
  }

  const CartesianGrid& Grid;
  const FractionField& From;
  const int Axis;
  const IndexBox Box;
  std::vector<Shares> SharesAt; // by cell of the box along the axis
};

FractionField AverageAlong(const CartesianGrid& grid, const FractionField& from, int axis,
  const IndexBox& box, Runtime& runtime)
{
  FractionField to(grid, from.NumberOfMaterials());
  const RowAverage average(grid, from, axis, box);
  const Index rows = std::max<Index>(box.Size(1), 0);
  std::vector<RowOfAverages> averages(rows); // of a layer
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    ForEach(
      runtime, rows, [&](Index row) { average.AverageRow(box.Lower[1] + row, k, averages[row]); });
    for (Index row = 0; row < rows; ++row)
    {
      average.StoreRow(box.Lower[1] + row, k, averages[row], to);
    }
  }
  return to;
}

} // namespace

FractionField AverageFractions(const CartesianGrid& grid, FractionField fractions, int passes,
  const Partition& partition, Runtime& runtime)
{
  int layers = GhostLayers; // ghost layers with valid fractions
  for (int pass = 0; pass < passes; ++pass)
  {
    if (layers == 1)
    {
      FillGhosts(partition, fractions);
      layers = GhostLayers;
    }
    IndexBox box = grid.Extended(layers);
    --layers;
    const IndexBox inner = grid.Extended(layers);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Lower[axis] = inner.Lower[axis];
      box.Upper[axis] = inner.Upper[axis];
      fractions = AverageAlong(grid, fractions, axis, box, runtime);
    }
  }
  return fractions;
}

} // namespace vfm
