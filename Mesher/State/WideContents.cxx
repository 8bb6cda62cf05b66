#include "State/WideContents.h"

#include "Fractions/ResampleFields.h"

namespace vfm
{
namespace
{

CellOverlaps OverlapsOf(const DonorCells& read, const CartesianGrid& grid)
{
  return FindOverlaps(read.GetGrid().Coordinates(), grid.Coordinates(), grid.Local());
}

/// Sums the contents of the cells that a cell overlaps, in their order.
ContentSums SumCells(const DonorCells& read, const CellOverlaps& overlaps,
  const CartesianGrid& grid, const Index3& cell)
{
  ContentSums sums;
  std::vector<double> values(read.GetContents().NumberOfColumns());
  ForCells(Overlapped(overlaps, BoxOfCell(cell)),
    [&](const Index3& p)
    {
      double volume = 1.0; // of the common part of both cells
      for (int a = 0; a < 3; ++a)
      {
        volume *= overlaps[a].Share(cell[a], p[a]) * grid.Width(a, cell[a]);
      }
      read.GetFractions().ForParts(read.GetGrid().Linear(p),
        [&](int material, double fraction)
        {
          read.Read(p, material, values.data());
          sums.Add(read.GetContents(), material, volume * fraction, values.data());
        });
    });
  return sums;
}

/// Finds the means of the local cells of a grid.
MeanContents FindMeans(
  const DonorCells& read, const CellOverlaps& overlaps, const CartesianGrid& grid, Runtime& runtime)
{
  MeanContents means;
  const IndexBox& box = grid.Local();
  for (Index k = box.Lower[2]; box.NumberOfCells() > 0 && k < box.Upper[2]; ++k)
  {
    const IndexBox layer{ { { box.Lower[0], box.Lower[1], k } },
      { { box.Upper[0], box.Upper[1], k + 1 } } };
    std::vector<ContentSums> sums(layer.NumberOfCells());
    ForEach(runtime, sums.size(),
      [&](Index c) { sums[c] = SumCells(read, overlaps, grid, CellInBox(layer, c)); });
    for (const ContentSums& own : sums)
    {
      means.Store(own);
    }
  }
  return means;
}

} // namespace

WideContents::WideContents(const DonorCells& read, const CartesianGrid& grid, Runtime& runtime) :
  Contents(read.GetContents()),
  Grid(grid),
  Fractions(MeanFractions(
    read.GetGrid(), read.GetFractions(), OverlapsOf(read, grid), grid, grid.Local(), runtime)),
  Means(FindMeans(read, OverlapsOf(read, grid), grid, runtime))
{
}

void WideContents::Read(const Index3& cell, int material, double* values) const
{
  this->Means.Read(static_cast<int>(IndexInBox(this->Grid.Local(), cell)), material,
    this->Contents.NumberOfColumns(), values);
}

} // namespace vfm
