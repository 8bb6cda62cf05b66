/**
 * OctantFamilies: the refined cells of each level. Cells are refined in families of 2x2x2 cells of
 * a level (OctreeKeys.h).
 *
 * The sets are closed, so that refinement makes a mesh:
 *
 * Balance: A family of level l + 1 is a cell of level l. This cell and the 18 cells that share a
 * face or an edge with it lie in refined families of level l.
 *
 * Manifold: If two refined families lie at opposite corners of 3x3 families of a plane, one of the
 * five between them (all except the two other corners) is refined too. Otherwise, transition hexes
 * around the two families would share an edge but not a face: a non-manifold edge.
 *
 * Closing proceeds from the finest level to the coarsest. Families are added in rounds, each
 * based on the sets of the previous round, so the result does not depend on any order. The rank
 * that owns the first cell of a family adds it and sends it to the ranks that read it
 * (FamilyOwners.h). Rounds end when no rank has added a family.
 * Essentially after Owen, Shih, Ernst, Computer-Aided Design (2017); the rule of non-manifold
 * edges was found by testing.
 *
 * Tets need no pillowing (CoarseTets.h). For them, single cells are refined instead of families,
 * and there is no rule of non-manifold edges. A cell that shares a face or an edge with a refined
 * cell of its level is of this level or refined, so cells that share an edge differ by at most one
 * level.
 *
 * A rank holds the families that overlap its part of the grid and some cells of their level
 * around it. Memory is proportional to them: one sorted list of keys per level.
 */
#pragma once

#include "Base/Options.h"
#include "Octree/OctreeKeys.h"
#include "Ranks/Ranks.h"

namespace vfm
{

class FamilyOwners;

/// Closed sets of refined families near one rank. Refers to the lattice, which must outlive it.
/// Thread safe once made.
class OctantFamilies
{
public:
  /// Number of cells of each level around the part of a rank whose families it holds too: one more
  /// than the transition hexes and the interfaces of a level depend on.
  static constexpr Index CellsAround = 9;

  /// Numbers of families of a level on all ranks, by reason. Copies do not count.
  struct LevelReport
  {
    Index Requested = 0;   ///< requested families
    Index Balance = 0;     ///< families added because the next level needs them
    Index NonManifold = 0; ///< families added by the rule of non-manifold edges
    int Rounds = 0;        ///< rounds in which this rule added families
  };

  /// Closes the sets of families that the ranks request. Stores a reference to the lattice.
  /// @param requested  keys of families (OctreeKeys::FamilyKey) for each refinement, in any order,
  /// possibly repeated, that this rank requests. Missing lists are empty. The farther they are from
  /// its cells, the more ranks exchange families. Those of a rank without cells do not count.
  /// @param unit  Cell: a cell has the key of the family that its children are: FamilyKey(level +
  /// 1, cell)
  /// @param part  base cells in and around which this rank reads families; contains the owned ones
  /// @pre Collective over `ranks`, if there are refinements.
  OctantFamilies(const OctreeKeys& lattice, const std::vector<std::vector<Index>>& requested,
    RefinedUnit unit, const IndexBox& part, Ranks& ranks);
  /// Closes the sets of a grid of which one rank owns all cells.
  OctantFamilies(const OctreeKeys& lattice, const std::vector<std::vector<Index>>& requested,
    RefinedUnit unit = RefinedUnit::Family);

  const OctreeKeys& Lattice() const { return this->TheLattice; }
  int NumberOfRefinements() const { return this->TheLattice.NumberOfRefinements(); }
  RefinedUnit UnitOfSets() const { return this->Unit; }
  /// Returns the level whose families have the keys of the set of a level.
  int FamilyLevel(int level) const { return level + (this->Unit == RefinedUnit::Cell); }
  /// Returns the keys of the refined families, or cells, of a level near this rank, ascending.
  const std::vector<Index>& Keys(int level) const { return this->Sets[level]; }
  const LevelReport& Report(int level) const { return this->Reports[level]; }

  /// Returns whether a family, or cell, is in the set of a level.
  /// @pre It is near this rank, or outside the grid, also for the functions below.
  bool HasFamily(int level, const Index3& family) const;
  /// Returns whether a cell is refined.
  bool IsRefined(int level, const Index3& cell) const
  {
    return this->HasFamily(level, this->Unit == RefinedUnit::Cell ? cell : ParentOfCell(cell));
  }
  /// Returns the axes (bits) along which a cell takes part in pillowing. Bit a is set if the cell
  /// is in the slab of a refined family along axis a, and in that family or next to it.
  /// @pre The cell is in the domain, and families are refined.
  int FindSlabs(int level, const Index3& cell) const;
  /// Returns whether the cell is refined or shares a face or an edge with a refined cell; false on
  /// the finest level.
  bool IsTouched(int level, const Index3& cell) const;

private:
  void Close(const std::vector<std::vector<Index>>& requested, const IndexBox& part, Ranks& ranks);
  IndexBox CellsNear(int level, const IndexBox& part) const;
  std::vector<Index> FindBalance(int level, const FamilyOwners& owners) const;
  std::vector<Index> FillNonManifoldEdges(
    int level, const std::vector<Index>& front, const FamilyOwners& owners) const;
  void CloseNonManifoldEdges(
    const FamilyOwners& owners, const IndexBox& part, Ranks& ranks, int level);
  void SumReports(Ranks& ranks);

  const OctreeKeys& TheLattice;
  RefinedUnit Unit;
  std::vector<std::vector<Index>> Sets;
  std::vector<LevelReport> Reports;
};

} // namespace vfm
