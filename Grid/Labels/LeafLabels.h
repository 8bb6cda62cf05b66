/**
 * Labels of the leaves of a refined grid: the cells that are not refined further (RefinedGrid.h). They are kept as labels of
 * the finest cells, alike within each leaf, so that all who read labels see a regular grid.
 */
#pragma once

#include "Labels/Labels.h"
#include "Octree/RefinedGrid.h"

namespace vfm
{

/// What has one label and changes it as a whole: a cell of the grid or, with levels, a leaf. A unit is called by the linear
/// index of its lowest cell in the local box. Leaves at the rim of the local box count as far as they lie inside.
class LabelUnits
{
public:
  /// leaves: null when units are cells. Keeps references.
  LabelUnits(const CartesianGrid& grid, const RefinedGrid* leaves) : Grid(grid), Leaves(leaves) {}

  /// Cells along an edge of the largest units.
  int LargestWidth() const { return this->Leaves ? 1 << this->Leaves->NumberOfRefinements() : 1; }

  /// The unit of a cell of the local box, or of the one that a cell beside it mirrors.
  Index UnitOf(const Index3& cell) const
  {
    const Index3 inside = this->Grid.Local().Nearest(cell);
    return this->IsCell(inside) ? this->Grid.Linear(inside)
                                : this->Grid.Linear(this->LeafCells(inside).Lower);
  }
  IndexBox CellsOf(Index unit) const
  {
    const Index3 p = this->Grid.Position(unit);
    return this->IsCell(p) ? BoxOfCell(p) : this->LeafCells(p);
  }
  /// The cells of the star of a node on the surface of a unit that belong to the unit or mirror it: a mask of eight bits.
  int RegionAt(const Index3& node, const IndexBox& cells) const
  {
    constexpr std::array<int, 3> Low{ { 0x55, 0x33, 0x0f } }; // the cells of a star on the - side
    const IndexBox& box = this->Grid.Local();
    int region = 0xff;
    for (int a = 0; a < 3; ++a)
    {
      const bool low = node[a] > cells.Lower[a] || node[a] == box.Lower[a];
      const bool high = node[a] < cells.Upper[a] || node[a] == box.Upper[a];
      region &= (low ? Low[a] : 0) | (high ? ~Low[a] : 0);
    }
    return region;
  }

private:
  bool IsCell(const Index3& cell) const { return !this->Leaves || this->Leaves->IsFine(cell); }
  IndexBox LeafCells(const Index3& cell) const;

  const CartesianGrid& Grid;
  const RefinedGrid* Leaves;
};

/// Gives the cells of a box of the local box a label, and the cells that mirror them.
void FillLabels(const CartesianGrid& grid, const IndexBox& cells, int label, LabelArray& labels);

/// AssignMaterials of the leaves, by their mean fractions. fractions, labels: of the cells of levels.Finest().
LabelArray AssignLeafMaterials(
  const RefinedGrid& levels, const FractionField& fractions, LabelArray labels, double isoValue);

} // namespace vfm
