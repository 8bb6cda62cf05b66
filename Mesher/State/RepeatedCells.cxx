#include "State/RepeatedCells.h"

#include "Fractions/GhostFractions.h"

namespace vfm
{

RepeatedCells::RepeatedCells(const DonorCells& cells, const CartesianGrid& meshed, Ranks& ranks) :
  Cells(cells)
{
  if (meshed.IsPeriodic())
  {
    this->Copies = { cells.GetGrid(), cells.GetFractions() };
    ReplaceGrid(meshed.WithCells(
                  cells.GetGrid().Coordinates(), cells.GetGrid().Owned(), GhostLayers, GhostLayers),
      ranks, this->Copies->Grid, this->Copies->Fractions);
  }
}

void RepeatedCells::Read(const Index3& cell, int material, double* values) const
{
  Index3 own = cell;
  for (int a = 0; a < 3; ++a)
  {
    own[a] -= this->GetGrid().Domain().Lower[a];
  }
  this->Cells.Read(own, material, values);
}

} // namespace vfm
