/**
 * OctreeKeys: the cells and nodes of all levels of a refined Cartesian grid, and keys of the points
 * and hexes that refinement makes.
 *
 * Level 0 is the base grid. Each level divides the cells of the previous level in two along every
 * axis: into halves, with coordinates bitwise identical to RefineCells, or at the given coordinates
 * of the finest level. A family of level l is the cells 2q to 2q + 1 of the level along each axis,
 * which is a cell of level l - 1. If level 0 has an odd number of cells, the upper half of its last
 * family is outside.
 *
 * Keys are global and need no communication. They number, level by level:
 *
 * Nodes: 27 slots per lattice node. Slot 0 is the lattice node itself, with a key of the coarsest
 * level that has it. The other slots are its copies (SlabPillow.h).
 *
 * Hexes: 343 slots per cell. Slot 0 is the remaining part of the cell, or all of it. The other
 * slots are hexes made on its faces.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// Coordinates and keys of all levels. Refers to the base grid, which must outlive it. Thread safe
/// once made.
class OctreeKeys
{
public:
  static constexpr Index NodeSlots = 27, HexSlots = 343;

  /// Node or cell of a level, and its slot.
  struct LevelIndex
  {
    int Level;
    Index3 At;
    int Slot;
  };

  /// Halves all cells. Stores a reference to the grid.
  /// @param refinements  number of levels above level 0
  /// @throws InputError  if keys need more than 64 bits
  OctreeKeys(const CartesianGrid& base, int refinements);
  /// Uses given coordinates instead of halves.
  /// @param finest  coordinates of the nodes of the finest level along each axis
  OctreeKeys(const CartesianGrid& base, int refinements, std::array<std::vector<double>, 3> finest);

  const CartesianGrid& Base() const { return this->Grid; }
  int NumberOfRefinements() const { return static_cast<int>(this->NodeOffset.size()) - 1; }

  Index Cells(int level, int axis) const { return this->Grid.Global().Upper[axis] << level; }
  Index Families(int level, int axis) const { return (this->Cells(level, axis) + 1) / 2; }
  bool HasCell(int level, const Index3& cell) const;
  bool HasFamily(int level, const Index3& family) const;

  /// Returns a coordinate of a node in length units of the grid.
  double Coordinate(int level, int axis, Index i) const
  {
    return this->X[axis][i << (this->NumberOfRefinements() - level)];
  }
  Vector3 NodePoint(int level, const Index3& node) const;
  /// Convert lattice coordinates, in which cells of level 0 are unit cubes divided into halves, to
  /// length units and back.
  Vector3 ToPoint(const Vector3& x) const;
  Vector3 FromPoint(const Vector3& point) const;
  Vector3 CellWidths(int level, const Index3& cell) const;
  /// Returns the sides of the domain on which a node lies: bit f is set for side f.
  int DomainSides(int level, const Index3& node) const;
  /// Returns the axes across which a node lies on a flat seam: bit a is set for axis a.
  int FlatSeams(int level, const Index3& node) const;

  Index FamilyKey(int level, const Index3& family) const;
  /// Returns the key of the family of a cell.
  Index FamilyKeyOf(const LevelIndex& cell) const
  {
    return this->FamilyKey(cell.Level, ParentOfCell(cell.At));
  }
  Index3 FamilyOfKey(int level, Index key) const;
  /// NodeKey returns the key of a copy, or for slot 0 the key of the node on this level. LatticeKey
  /// returns the key of the node on its coarsest level, which meshes use.
  Index NodeKey(int level, const Index3& node, int slot) const;
  Index LatticeKey(int level, Index3 node) const;
  Index HexKey(int level, const Index3& cell, int slot) const;
  LevelIndex NodeOfKey(Index key) const;
  LevelIndex HexOfKey(Index key) const;

private:
  const CartesianGrid& Grid;
  std::array<std::vector<double>, 3> X;     // coordinates of the nodes of the finest level
  std::vector<Index> NodeOffset, HexOffset; // first key of each level
};

/// Returns the base cell that contains a cell of a level.
inline Index3 BaseCellOf(const OctreeKeys::LevelIndex& cell)
{
  return { { cell.At[0] >> cell.Level, cell.At[1] >> cell.Level, cell.At[2] >> cell.Level } };
}

} // namespace vfm
