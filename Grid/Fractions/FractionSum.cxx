#include "Fractions/FractionSum.h"

namespace vfm
{

void FractionSum::Add(const FractionField& fractions, Index cell, double share)
{
  fractions.ForParts(cell,
    [&](int material, double fraction)
    { PartOf(this->List, material).Fraction += share * fraction; });
}

void FractionSum::Divide(double by)
{
  for (FractionField::Part& part : this->List)
  {
    part.Fraction /= by;
  }
}

double FractionSum::Fraction(int material) const
{
  return FractionField::FractionOf(this->List, material);
}

FractionSum MeanOfCells(
  const CartesianGrid& grid, const FractionField& fractions, const IndexBox& cells)
{
  FractionSum mean;
  if (cells.NumberOfCells() == 1)
  {
    mean.Add(fractions, grid.Linear(cells.Lower), 1.0);
    return mean;
  }
  double volume = 0.0;
  ForCells(cells,
    [&](const Index3& p)
    {
      const double cellVolume = grid.CellVolume(p);
      volume += cellVolume;
      mean.Add(fractions, grid.Linear(p), cellVolume);
    });
  mean.Divide(volume);
  return mean;
}

} // namespace vfm
