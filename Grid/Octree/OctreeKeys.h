/**
 * OctreeKeys: the cells and nodes of all levels of a refined Cartesian grid, and the keys of what refinement makes.
 *
 * Level 0 is the base grid; each level cuts the cells of the one before in two along every axis: in halves, as RefineCells
 * does, with the same coordinates bit for bit, or where the coordinates of the finest level say. A family of level l is the cells 2q .. 2q + 1 of it along each axis: a cell of level
 * l - 1, or where level 0 has an odd number of cells, one whose upper half lies outside.
 *
 * Keys are global and need no communication. They number, level by level,
 *   nodes: 27 slots a lattice node. Slot 0 is the lattice node itself, keyed on the coarsest level that has it. The others
 *          are its copies (SlabPillow.h).
 *   hexes: 343 slots a cell. Slot 0 is what is left of the cell, or all of it; the others were made on its faces.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

class OctreeKeys
{
public:
  static constexpr Index NodeSlots = 27, HexSlots = 343;

  /// A node or cell of a level, and its slot.
  struct LevelIndex
  {
    int Level;
    Index3 At;
    int Slot;
  };

  /// refinements: how many levels there are above level 0. Keeps a reference to the grid. Throws InputError
  /// when keys do not fit.
  OctreeKeys(const CartesianGrid& base, int refinements);
  /// finest: coordinates of the nodes of the finest level, where they are not halves.
  OctreeKeys(const CartesianGrid& base, int refinements, std::array<std::vector<double>, 3> finest);

  const CartesianGrid& Base() const { return this->Grid; }
  int NumberOfRefinements() const { return static_cast<int>(this->NodeOffset.size()) - 1; }

  Index Cells(int level, int axis) const { return this->Grid.Global().Upper[axis] << level; }
  Index Families(int level, int axis) const { return (this->Cells(level, axis) + 1) / 2; }
  bool HasCell(int level, const Index3& cell) const;
  bool HasFamily(int level, const Index3& family) const;

  /// Length units of the grid.
  double Coordinate(int level, int axis, Index i) const
  {
    return this->X[axis][i << (this->NumberOfRefinements() - level)];
  }
  Vector3 NodePoint(int level, const Index3& node) const;
  /// From lattice coordinates, in which the cells of level 0 are unit cubes cut in halves, to length units, and back.
  Vector3 ToPoint(const Vector3& x) const;
  Vector3 FromPoint(const Vector3& point) const;
  Vector3 CellWidths(int level, const Index3& cell) const;
  /// Bit f set when the node lies on side f of the domain.
  int DomainSides(int level, const Index3& node) const;

  Index FamilyKey(int level, const Index3& family) const;
  /// Of the family that a cell is in.
  Index FamilyKeyOf(const LevelIndex& cell) const
  {
    return this->FamilyKey(cell.Level, ParentOfCell(cell.At));
  }
  Index3 FamilyOfKey(int level, Index key) const;
  /// The key of a copy, or with slot 0 of the node as one of its level; LatticeKey is what the mesh calls the latter.
  Index NodeKey(int level, const Index3& node, int slot) const;
  Index LatticeKey(int level, Index3 node) const;
  Index HexKey(int level, const Index3& cell, int slot) const;
  LevelIndex NodeOfKey(Index key) const;
  LevelIndex HexOfKey(Index key) const;

private:
  const CartesianGrid& Grid;
  std::array<std::vector<double>, 3> X;     // of the nodes of the finest level
  std::vector<Index> NodeOffset, HexOffset; // of the keys of each level
};

/// The base cell around a cell of a level.
inline Index3 BaseCellOf(const OctreeKeys::LevelIndex& cell)
{
  return { { cell.At[0] >> cell.Level, cell.At[1] >> cell.Level, cell.At[2] >> cell.Level } };
}

} // namespace vfm
