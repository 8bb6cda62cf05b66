#include "Labels/LeafLabels.h"

namespace vfm
{
namespace
{

/// The mean fractions of a box of cells, as FractionField::Parts.
std::vector<FractionField::Part> MeanParts(
  const CartesianGrid& grid, const FractionField& fractions, const IndexBox& cells)
{
  std::vector<FractionField::Part> parts;
  double volume = 0.0;
  const auto add = [&](int material, double amount)
  {
    const auto at = std::lower_bound(parts.begin(), parts.end(), material,
      [](const FractionField::Part& part, int m) { return part.Material < m; });
    if (at != parts.end() && at->Material == material)
    {
      at->Fraction += amount;
      return;
    }
    parts.insert(at, { material, amount });
  };
  ForCells(cells,
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p);
      const double cellVolume = grid.CellVolume(p);
      volume += cellVolume;
      if (!fractions.IsMixed(cell))
      {
        add(fractions.Label(cell), cellVolume);
        return;
      }
      for (const FractionField::Part& part : fractions.Parts(cell))
      {
        add(part.Material, cellVolume * part.Fraction);
      }
    });
  for (FractionField::Part& part : parts)
  {
    part.Fraction /= volume;
  }
  return parts;
}

} // namespace

IndexBox LabelUnits::LeafCells(const Index3& cell) const
{
  const OctreeKeys::LevelIndex leaf = this->Leaves->LeafOf(cell);
  return Intersect(this->Leaves->FinestCells(leaf.Level, leaf.At), this->Grid.Local());
}

double MeanFraction(
  const CartesianGrid& grid, const FractionField& fractions, const IndexBox& cells, int material)
{
  if (cells.NumberOfCells() == 1)
  {
    return fractions.Fraction(grid.Linear(cells.Lower), material); // the division would round
  }
  double amount = 0.0, volume = 0.0;
  ForCells(cells,
    [&](const Index3& p)
    {
      const double cellVolume = grid.CellVolume(p);
      volume += cellVolume;
      amount += cellVolume * fractions.Fraction(grid.Linear(p), material);
    });
  return amount / volume;
}

void FillLabels(const CartesianGrid& grid, const IndexBox& cells, int label, LabelArray& labels)
{
  IndexBox box = cells; // with the mirrors
  for (int a = 0; a < 3; ++a)
  {
    box.Lower[a] -= cells.Lower[a] == grid.Local().Lower[a];
    box.Upper[a] += cells.Upper[a] == grid.Local().Upper[a];
  }
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      labels.Fill(first, first + box.Size(0), label);
    }
  }
}

/// A leaf whose finest cells all have one label has it by its mean, too: where one material is the largest in each cell it is
/// so in their sum, likewise void. So only leaves with a mixed node inside need their mean.
LabelArray AssignLeafMaterials(
  const RefinedGrid& levels, const FractionField& fractions, double isoValue)
{
  const CartesianGrid& grid = levels.Finest();
  LabelArray labels = AssignMaterials(grid, fractions, isoValue);
  const LabelUnits units(grid, &levels);
  std::vector<Index> mixed;
  for (Index node : FindMixedNodes(grid, labels))
  {
    const Index3 p = grid.Position(node);
    const Index unit = units.UnitOf(p);
    if (unit == units.UnitOf(CellOfStar(p, 0)))
    {
      mixed.push_back(unit);
    }
  }
  std::sort(mixed.begin(), mixed.end());
  mixed.erase(std::unique(mixed.begin(), mixed.end()), mixed.end());
  for (Index unit : mixed)
  {
    const IndexBox cells = units.CellsOf(unit);
    const std::vector<FractionField::Part> parts = MeanParts(grid, fractions, cells);
    const int label = MaterialOfParts({ parts.data(), parts.data() + parts.size() }, isoValue);
    FillLabels(grid, cells, label, labels);
  }
  return labels;
}

} // namespace vfm
