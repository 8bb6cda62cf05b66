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

/// Averages along one axis, row by row.
class RowAverage
{
public:
  RowAverage(const CartesianGrid& grid, const FractionField& from, int axis) :
    Grid(grid), From(from), Axis(axis)
  {
  }

  bool IsPure(Index cell, const Shares& shares) const
  {
    const Index step = this->Grid.Stride(this->Axis);
    const auto same = [&](Index other)
    { return !this->From.IsMixed(other) && this->From.Label(other) == this->From.Label(cell); };
    return !this->From.IsMixed(cell) && (shares.Lower == 0.0 || same(cell - step)) &&
      (shares.Upper == 0.0 || same(cell + step));
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

  /// Appends the averages of the cells of a row that are not pure, x fastest.
  void AverageRow(const IndexBox& box, Index j, Index k, std::vector<FractionSum>& mixed) const
  {
    for (Index i = box.Lower[0]; i < box.Upper[0]; ++i)
    {
      const Index3 p{ { i, j, k } };
      const Shares shares = FindShares(this->Grid, this->Axis, p[this->Axis]);
      const Index cell = this->Grid.Linear(p);
      if (!this->IsPure(cell, shares))
      {
        mixed.emplace_back();
        this->Average(cell, shares, mixed.back());
      }
    }
  }

  void StoreRow(const IndexBox& box, Index j, Index k, const std::vector<FractionSum>& mixed,
    FractionField& to) const
  {
    auto next = mixed.begin();
    FractionField::RowWriter row(to);
    row.Start(this->Grid.Linear({ { box.Lower[0], j, k } }));
    for (Index i = box.Lower[0]; i < box.Upper[0]; ++i)
    {
      const Index3 p{ { i, j, k } };
      const Index cell = this->Grid.Linear(p);
      if (this->IsPure(cell, FindShares(this->Grid, this->Axis, p[this->Axis])))
      {
        row.AddLabel(this->From.Label(cell));
        continue;
      }
      row.CopyParts((next++)->Parts());
    }
    row.Finish();
  }

private:
  const CartesianGrid& Grid;
  const FractionField& From;
  int Axis;
};

FractionField AverageAlong(const CartesianGrid& grid, const FractionField& from, int axis,
  const IndexBox& box, Runtime& runtime)
{
  FractionField to(grid, from.NumberOfMaterials());
  const RowAverage average(grid, from, axis);
  const Index rows = std::max<Index>(box.Size(1), 0);
  std::vector<std::vector<FractionSum>> mixed(rows); // one per row of a layer
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    ForEach(runtime, rows,
      [&](Index row)
      {
        mixed[row].clear();
        average.AverageRow(box, box.Lower[1] + row, k, mixed[row]);
      });
    for (Index row = 0; row < rows; ++row)
    {
      average.StoreRow(box, box.Lower[1] + row, k, mixed[row], to);
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
