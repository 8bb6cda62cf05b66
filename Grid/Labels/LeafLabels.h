/**
 * LeafLabels: labels of the leaves of a refined grid, the cells that are not refined further
 * (RefinedGrid.h). They are stored as labels of the finest cells, equal within each leaf, so code
 * that reads labels sees a regular grid.
 */
#pragma once

#include "Labels/Labels.h"
#include "Octree/RefinedGrid.h"

namespace vfm
{

/// Units of labels. A unit has one label and changes it as a whole: it is a cell of the grid or,
/// with levels, a leaf. Cells that are glued across flat seams (SeamBlocks.h) can also be one unit.
/// A unit is identified by the linear index of its lowest cell in the local box. Leaves at the rim
/// of the local box consist of their cells inside it.
class LabelUnits
{
public:
  /// @param grid,leaves,glued  must outlive this object; leaves: nullptr if units are cells; glued:
  ///   labels of cells that determine which of them are glued, or nullptr
  LabelUnits(
    const CartesianGrid& grid, const RefinedGrid* leaves, const LabelArray* glued = nullptr) :
    Grid(grid), Leaves(leaves), Glued(glued)
  {
  }

  /// Returns the number of cells along an edge of the largest units.
  int LargestWidth() const { return this->Leaves ? 1 << this->Leaves->NumberOfRefinements() : 1; }

  /// Returns the unit of a cell of the local box, or of the cell that a cell outside it mirrors.
  Index UnitOf(const Index3& cell) const
  {
    const Index3 inside = this->Grid.Local().Nearest(cell);
    return this->Grid.Linear(this->IsCell(inside) ? inside : this->CellsAround(inside).Lower);
  }
  /// Returns the cells of a unit in the local box.
  IndexBox CellsOf(Index unit) const
  {
    const Index3 p = this->Grid.Position(unit);
    return this->IsCell(p) ? BoxOfCell(p) : this->CellsAround(p);
  }
  /// Returns the cells in the star of a node that belong to a unit or mirror it, as a
  /// mask of eight bits.
  /// @param node  node on the surface of the unit
  /// @param cells  CellsOf(unit)
  int RegionAt(const Index3& node, const IndexBox& cells) const
  {
    constexpr std::array<int, 3> Low{ { 0x55, 0x33, 0x0f } }; // cells of a star on the - side
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
  /// Returns whether a unit is known to be a cell.
  bool IsCell(const Index3& cell) const
  {
    return this->Leaves ? this->Leaves->IsFine(cell) : !this->Glued;
  }
  IndexBox CellsAround(const Index3& cell) const;

  const CartesianGrid& Grid;
  const RefinedGrid* Leaves;
  const LabelArray* Glued;
};

/// Sets the label of a box of cells in the local box, and of the cells that mirror them.
void FillLabels(const CartesianGrid& grid, const IndexBox& cells, int label, LabelArray& labels);

/// Labels the leaves by their mean fractions.
/// @param fractions  fractions of the cells of levels.Finest()
/// @param labels  AssignMaterials of the same cells
/// @return labels of the cells, equal within each leaf
LabelArray AssignLeafMaterials(
  const RefinedGrid& levels, const FractionField& fractions, LabelArray labels, double isoValue);

} // namespace vfm
