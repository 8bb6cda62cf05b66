#include "Fractions/AverageFractions.h"

#include "Fractions/FractionSum.h"
#include "Fractions/GhostFractions.h"

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

/// Cells of a row in order: of one label, or one cell with label -1.
struct Run
{
  Index End; // first cell behind the run, from the start of the row
  int Label;
};

/// The averages of a row.
struct RowOfAverages
{
  std::vector<Run> Runs;
  std::vector<FractionSum> Mixed; // of the cells with label -1
};

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
    row.Mixed.clear();
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
    auto next = averages.Mixed.begin();
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
        row.CopyParts((next++)->Parts());
      }
      begin = run.End;
    }
    row.Finish();
  }

private:
  /// Lists the runs of cells [range[0], range[1]) of a row that starts at cell `first`.
  std::vector<Run> ListRuns(Index first, const std::array<Index, 2>& range) const
  {
    std::vector<Run> runs;
    this->From.VisitRuns(first + range[0], first + range[1],
      [&](Index, Index end, int label) {
        runs.push_back({ end - first, label });
      });
    return runs;
  }

  /// Averages a range of a row in which all cells exchange, or none.
  template <class SharesOf>
  void AverageRange(Index first, const std::array<Index, 2>& range, bool exchanges,
    const SharesOf& sharesOf, RowOfAverages& row) const
  {
    const Index step = this->Grid.Stride(this->Axis);
    const std::vector<Run> own = this->ListRuns(first, range);
    const std::vector<Run> below = exchanges ? this->ListRuns(first - step, range) : own;
    const std::vector<Run> above = exchanges ? this->ListRuns(first + step, range) : own;
    const Run *o = own.data(), *b = below.data(), *a = above.data();
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
        row.Runs.push_back({ i + 1, -1 });
        row.Mixed.emplace_back();
        this->Average(first + i, sharesOf(i), row.Mixed.back());
      }
      i = end;
      o += o->End == end;
      b += b->End == end;
      a += a->End == end;
    }
  }

  void Average(Index cell, const Shares& shares, FractionSum& sum) const
  {
    const Index step = this->Grid.Stride(this->Axis);
    sum.Add(this->From, cell, 1.0 - (shares.Lower + shares.Upper));
    if (shares.Lower > 0.0)
    {
      sum.Add(this->From, cell - step, shares.Lower);
    }
    if (shares.Upper > 0.0)
    {
      sum.Add(this->From, cell + step, shares.Upper);
    }
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
