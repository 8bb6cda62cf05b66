/**
 * HalvedCells: which cells of each level are halved so that materials get cells of their widths
 * (option MaterialWidths).
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Cells of this rank that are halved, on levels from the coarsest to the last but one.
class HalvedCells
{
public:
  /// Halves no cell.
  /// @param owned finest cells of this rank
  HalvedCells(const IndexBox& owned, int halvings);

  int NumberOfLevels() const { return static_cast<int>(this->Flags.size()); }
  const IndexBox& Box(int level) const { return this->Boxes[level]; }
  bool Has(int level, const Index3& cell) const
  {
    return this->Flags[level][IndexInBox(this->Boxes[level], cell)] != 0;
  }
  void Halve(int level, const Index3& cell)
  {
    this->Flags[level][IndexInBox(this->Boxes[level], cell)] = 1;
  }
  /// Halves the cells that contain halved ones.
  void HalveParents();

private:
  std::vector<IndexBox> Boxes;
  std::vector<std::vector<unsigned char>> Flags; // by level and cell
};

/// Returns the cells that contain a material of narrower cells.
/// @param grid grid of the finest cells
/// @param ofMaterial numbers of halvings of materials 0, 1, .. (CellSizes)
HalvedCells FindHalved(const CartesianGrid& grid, const FractionField& fractions,
  const std::vector<int>& ofMaterial, int halvings);

/// Returns the families (OctreeKeys::FamilyKey) of halved cells and of layers of cells around them,
/// ascending, one list per level.
/// @param base grid of the coarsest cells
/// @param repeats axes along which the domain repeats
std::vector<std::vector<Index>> FamiliesOf(const HalvedCells& halved, const CartesianGrid& base,
  const std::array<bool, 3>& repeats, Index layers);

} // namespace vfm
