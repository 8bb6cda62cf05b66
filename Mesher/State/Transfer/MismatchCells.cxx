#include "State/Transfer/MismatchCells.h"

namespace vfm
{
namespace
{

constexpr double Rounding = 1e-12; // fraction of a cell's volume that counts as rounding

/// State of the search for the mismatch cells that this rank owns.
struct Work
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const WholeElements& Whole;
  const DonorTable& Donors;
  const std::vector<unsigned char>& IsMeshed;
  std::vector<Index> Cells{};
};

/// Returns whether a cell is not a mismatch cell.
bool Fits(const Work& work, Index cell, double volume)
{
  if (work.Whole.Covers(cell))
  {
    return true;
  }
  if (work.Fractions.IsMixed(cell))
  {
    return false;
  }
  const int label = work.Fractions.Label(cell);
  double own = work.IsMeshed[label] ? volume : 0.0, others = 0.0;
  work.Donors.ForCell(cell,
    [&](int s)
    {
      const Donor& donor = work.Donors[s];
      (donor.Material == label ? own : others) -= donor.Overlap;
    });
  return std::fabs(own) <= Rounding * volume && -others <= Rounding * volume;
}

std::vector<Index> Find(Work& work)
{
  const IndexBox& box = work.Grid.Owned();
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = work.Grid.Linear({ { box.Lower[0], j, k } });
      const double section = work.Grid.Width(1, j) * work.Grid.Width(2, k);
      const auto look = [&](Index begin, Index end)
      {
        for (Index cell = begin; cell < end; ++cell)
        {
          const double width = work.Grid.Width(0, box.Lower[0] + cell - first);
          if (!Fits(work, cell, width * section))
          {
            work.Cells.push_back(cell);
          }
        }
      };
      work.Fractions.Visit(
        first, first + box.Size(0), [&](Index begin, Index end, int) { look(begin, end); }, look);
    });
  return std::move(work.Cells);
}

} // namespace

MismatchCells::MismatchCells(const CartesianGrid& grid, const FractionField& fractions,
  const WholeElements& whole, const DonorTable& donors, const std::vector<unsigned char>& isMeshed,
  const Partition& partition) :
  Grid(grid), Nearness(grid, 0)
{
  Work work{ grid, fractions, whole, donors, isMeshed };
  std::vector<Index> mismatches = Find(work);
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
