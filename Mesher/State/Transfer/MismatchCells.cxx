#include "State/Transfer/MismatchCells.h"

namespace vfm
{
namespace
{

constexpr double Rounding = 1e-12; // fraction of a cell's volume that counts as rounding

/// Returns whether donors of a cell overlap it like its only material, and no other material does.
/// @param label  material of the cell
/// @param required  volume of the cell, or 0 if its material has no elements
/// @param allowed  largest difference of volumes
bool IsFilled(const DonorTable& donors, Index cell, int label, double required, double allowed)
{
  double own = required, others = 0.0;
  donors.ForCell(cell,
    [&](int s)
    {
      const Donor& donor = donors[s];
      (donor.Material == label ? own : others) -= donor.Overlap;
    });
  return std::fabs(own) <= allowed && -others <= allowed;
}

/// Returns the owned cells for which fits(cell, volume) is false.
template <class Fits>
std::vector<Index> FindMismatches(
  const CartesianGrid& grid, const FractionField& fractions, const Fits& fits)
{
  std::vector<Index> cells;
  const IndexBox& box = grid.Owned();
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      const double section = grid.Width(1, j) * grid.Width(2, k);
      const auto look = [&](Index begin, Index end)
      {
        for (Index cell = begin; cell < end; ++cell)
        {
          const double width = grid.Width(0, box.Lower[0] + cell - first);
          if (!fits(cell, width * section))
          {
            cells.push_back(cell);
          }
        }
      };
      fractions.Visit(
        first, first + box.Size(0), [&](Index begin, Index end, int) { look(begin, end); }, look);
    });
  return cells;
}

} // namespace

MismatchCells::MismatchCells(const CartesianGrid& grid, const FractionField& fractions,
  const WholeElements& whole, const DonorTable& donors, const std::vector<unsigned char>& isMeshed,
  const Partition& partition) :
  Grid(grid), Nearness(grid, 0)
{
  const auto fits = [&](Index cell, double volume)
  {
    const auto isFilled = [&](int label)
    { return IsFilled(donors, cell, label, isMeshed[label] ? volume : 0.0, Rounding * volume); };
    return whole.Covers(cell) || (!fractions.IsMixed(cell) && isFilled(fractions.Label(cell)));
  };
  std::vector<Index> mismatches = FindMismatches(grid, fractions, fits);
  for (Index cell : mismatches)
  {
    this->Nearness.Set(cell, DonorLayers + 1);
  }
  partition.ExchangeCells(
    this->Nearness, [&mismatches](Index cell) { mismatches.push_back(cell); });
  this->MarkAround(std::move(mismatches));
}

void MismatchCells::MarkAround(std::vector<Index> cells)
{
  const std::array<Index, 27> steps = StepsAround(this->Grid);
  for (int nearness = DonorLayers; nearness > 0; --nearness)
  {
    std::vector<Index> next;
    for (Index cell : cells)
    {
      const bool isLocal = this->Grid.Local().Contains(this->Grid.Position(cell));
      for (int n = 0; isLocal && n < 27; ++n)
      {
        const Index other = cell + steps[n];
        if (this->Nearness[other] == 0)
        {
          this->Nearness.Set(other, nearness);
          next.push_back(other);
        }
      }
    }
    cells = std::move(next);
  }
}

} // namespace vfm
