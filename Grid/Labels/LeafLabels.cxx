#include "Labels/LeafLabels.h"

#include "Base/Sorted.h"
#include "Fractions/FractionSum.h"
#include "Labels/SeamBlocks.h"

namespace vfm
{

IndexBox LabelUnits::CellsAround(const Index3& cell) const
{
  if (!this->Leaves)
  {
    const IndexBox block = BlockOfCell(this->Grid, cell);
    return PartOfBlock(block, FindGluedAxes(this->Grid, *this->Glued, block), cell);
  }
  const OctreeKeys::LevelIndex leaf = this->Leaves->LeafOf(cell);
  return Intersect(this->Leaves->FinestCells(leaf.Level, leaf.At), this->Grid.Local());
}

void FillLabels(const CartesianGrid& grid, const IndexBox& cells, int label, LabelArray& labels)
{
  IndexBox box = cells; // the cells and their mirrors
  for (int a = 0; a < 3; ++a)
  {
    box.Lower[a] -= cells.Lower[a] == grid.Local().Lower[a];
    box.Upper[a] += cells.Upper[a] == grid.Local().Upper[a];
  }
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      labels.Fill(first, first + box.Size(0), label);
    });
}

/// If all finest cells of a leaf have one label, their mean has it too: a material that is the
/// largest in each cell is the largest in their sum. The same holds for void. So only leaves with a
/// mixed node inside need their mean.
LabelArray AssignLeafMaterials(
  const RefinedGrid& levels, const FractionField& fractions, LabelArray labels, double isoValue)
{
  const CartesianGrid& grid = levels.Finest();
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
  SortUnique(mixed);
  for (Index unit : mixed)
  {
    const IndexBox cells = units.CellsOf(unit);
    FillLabels(grid, cells, MeanOfCells(grid, fractions, cells).Material(isoValue), labels);
  }
  return labels;
}

} // namespace vfm
