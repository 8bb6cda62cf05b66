#include "Levels/MaterialFits.h"

#include "Fractions/ResampleFields.h"

#include <cmath>

namespace vfm
{
namespace
{

/// Materials in the 27 cells around a cell, and their fractions there. Cells outside of the domain
/// have the fractions of the nearest cell inside.
class FractionsAround
{
public:
  FractionsAround(const CartesianGrid& grid, const FractionField& fractions, const Index3& cell)
  {
    for (int n = 0; n < 27; ++n)
    {
      const Index3 near = grid.Global().Nearest(CellAround(cell, n));
      fractions.ForParts(grid.Linear(near),
        [&](int material, double fraction) { this->ValuesOf(material)[n] = fraction; });
    }
  }

  bool HasOneMaterial() const { return this->Materials.size() == 1; }

  /// Returns the label at a place.
  /// @param place relative to the centre of the cell, in its widths, -1/2 to 1/2
  int LabelAt(const Vector3& place, double isoValue) const
  {
    const std::array<WeightedCell, 8> cells = WeightsAt(place);
    double material = 0.0, most = -1.0;
    int label = 0;
    for (std::size_t m = 0; m < this->Materials.size(); ++m)
    {
      const int id = this->Materials[m];
      double value = 0.0;
      for (const auto& [number, weight] : cells)
      {
        value += weight * this->Values[m][number];
      }
      material += id > 0 ? value : 0.0;
      const bool isMore = id > 0 && (value > most || (value == most && id < label));
      most = isMore ? value : most;
      label = isMore ? id : label;
    }
    return material < isoValue ? 0 : label;
  }

private:
  using Fractions = std::array<double, 27>;
  struct WeightedCell
  {
    int Number; // of CellAround
    double Weight;
  };

  Fractions& ValuesOf(int material)
  {
    const auto place = std::find(this->Materials.begin(), this->Materials.end(), material);
    const std::size_t m = place - this->Materials.begin();
    if (m == this->Materials.size())
    {
      this->Materials.push_back(material);
      this->Values.push_back({});
    }
    return this->Values[m];
  }

  /// Returns the eight cells between whose centres a place is.
  static std::array<WeightedCell, 8> WeightsAt(const Vector3& place)
  {
    std::array<WeightedCell, 8> cells;
    for (int c = 0; c < 8; ++c)
    {
      WeightedCell& cell = cells[c] = { 13, 1.0 };
      for (int a = 0, step = 1; a < 3; ++a, step *= 3)
      {
        const bool isNext = (c >> a & 1) != 0;
        cell.Weight *= isNext ? std::fabs(place[a]) : 1.0 - std::fabs(place[a]);
        cell.Number += !isNext ? 0 : place[a] < 0.0 ? -step : step;
      }
    }
    return cells;
  }

  std::vector<int> Materials;
  std::vector<Fractions> Values; // by material
};

/// The wider cells at the centres of some cells along an axis.
struct CentresOnAxis
{
  Index First;                ///< first of the cells
  std::vector<Index> Cells;   ///< wider cells
  std::vector<double> Places; ///< of the centres, relative to those of the wider cells

  /// Returns the cells whose centres are in a wider cell.
  std::array<Index, 2> Inside(Index wider) const
  {
    const auto range = std::equal_range(this->Cells.begin(), this->Cells.end(), wider);
    return { { this->First + (range.first - this->Cells.begin()),
      this->First + (range.second - this->Cells.begin()) } };
  }
};

CentresOnAxis FindCentres(
  const std::vector<double>& nodes, const std::vector<double>& wider, Index first, Index last)
{
  CentresOnAxis found{ first, {}, {} };
  for (Index i = first; i < last; ++i)
  {
    const double x = 0.5 * (nodes[i] + nodes[i + 1]);
    const Index cell = std::upper_bound(wider.begin(), wider.end(), x) - wider.begin() - 1;
    const double middle = 0.5 * (wider[cell] + wider[cell + 1]);
    found.Cells.push_back(cell);
    found.Places.push_back((x - middle) / (wider[cell + 1] - wider[cell]));
  }
  return found;
}

/// Returns the number of cells next to a cell that have another label.
Index CountSides(const CartesianGrid& grid, const LabelArray& labels, const Index3& cell)
{
  const int label = labels[grid.Linear(cell)];
  Index sides = 0;
  for (int a = 0; a < 3; ++a)
  {
    for (const Index step : { -1, 1 })
    {
      Index3 next = cell;
      next[a] += step;
      sides += grid.Global().Contains(next) && labels[grid.Linear(next)] != label;
    }
  }
  return sides;
}

void SumUp(Ranks& ranks, std::vector<MaterialFit>& fits)
{
  std::vector<Index> counts;
  for (const MaterialFit& fit : fits)
  {
    counts.insert(counts.end(), { fit.Cells, fit.Lost, fit.Gained, fit.Sides });
  }
  ranks.Sum(counts);
  for (std::size_t m = 0; m < fits.size(); ++m)
  {
    fits[m] = { counts[4 * m], counts[4 * m + 1], counts[4 * m + 2], counts[4 * m + 3] };
  }
}

/// Returns the wider cells at the centres of some cells.
IndexBox CellsAt(const std::array<CentresOnAxis, 3>& centres)
{
  IndexBox box;
  for (int a = 0; a < 3; ++a)
  {
    box.Lower[a] = centres[a].Cells.front();
    box.Upper[a] = centres[a].Cells.back() + 1;
  }
  return box;
}

/// Adds the cells whose centres are in a wider cell.
void AddCells(const CartesianGrid& grid, const LabelArray& labels, const FractionsAround& around,
  const std::array<CentresOnAxis, 3>& centres, const Index3& wider, double isoValue,
  std::vector<MaterialFit>& fits)
{
  IndexBox inside;
  for (int a = 0; a < 3; ++a)
  {
    const std::array<Index, 2> range = centres[a].Inside(wider[a]);
    inside.Lower[a] = range[0];
    inside.Upper[a] = range[1];
  }
  ForCells(inside,
    [&](const Index3& cell)
    {
      const int label = labels[grid.Linear(cell)];
      ++fits[label].Cells;
      if (!around.HasOneMaterial())
      {
        Vector3 place;
        for (int a = 0; a < 3; ++a)
        {
          place[a] = centres[a].Places[cell[a] - centres[a].First];
        }
        const int other = around.LabelAt(place, isoValue);
        fits[label].Lost += label != other;
        fits[other].Gained += label != other;
        fits[label].Sides += CountSides(grid, labels, cell);
      }
    });
}

} // namespace

std::vector<MaterialFit> FindFits(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const std::array<std::vector<double>, 3>& wider, double isoValue,
  Runtime& runtime)
{
  const IndexBox& owned = grid.Owned();
  std::vector<MaterialFit> fits(fractions.NumberOfMaterials() + 1);
  if (owned.NumberOfCells() > 0)
  {
    std::array<CentresOnAxis, 3> centres;
    for (int a = 0; a < 3; ++a)
    {
      centres[a] = FindCentres(grid.Coordinates(a), wider[a], owned.Lower[a], owned.Upper[a]);
    }
    const IndexBox box = CellsAt(centres);
    const CartesianGrid to(wider, box, 1);
    const FractionField means = MeanFractions(grid, fractions,
      FindOverlaps(grid.Coordinates(), wider, to.Local()), to, to.Local(), runtime);
    ForCells(box,
      [&](const Index3& cell)
      { AddCells(grid, labels, FractionsAround(to, means, cell), centres, cell, isoValue, fits); });
  }
  SumUp(runtime.Group(), fits);
  return fits;
}

} // namespace vfm
