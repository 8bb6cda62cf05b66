/**
 * OctantFamilies: which cells of each level are refined. Cells are refined in families, 2x2x2 cells of a level (OctreeKeys.h).
 *
 * The sets are closed, so that refinement makes a mesh:
 *   balance  a family of level l + 1, which is a cell of level l, and the 18 cells that share a face or an edge with it lie
 *           in refined families of level l;
 *   manifold  where two refined families lie at opposite corners of 3x3 families of a plane, one of the five between
 *           (all but the two other corners) is refined, too. Otherwise the transition hexes around the one and around the
 *           other would have an edge in common and no face: a non-manifold edge.
 * Closing goes from the finest level down. Families are added in rounds, each from the sets of the round before, so the
 * result does not depend on any order. After Owen, Shih, Ernst (2017) in substance; the rule of non-manifold edges was found by testing.
 *
 * Memory follows the refined families: a sorted list of keys a level.
 */
#pragma once

#include "Octree/OctreeKeys.h"

namespace vfm
{

class OctantFamilies
{
public:
  struct LevelReport
  {
    Index Requested = 0;   ///< families asked for
    Index Balance = 0;     ///< added because the next level needs them
    Index NonManifold = 0; ///< added by the rule of non-manifold edges
    int Rounds = 0;        ///< in which the rule of non-manifold edges added some
  };

  /// wanted: of each refinement, the keys of families (OctreeKeys::FamilyKey) in any order, repeated or not; fewer
  /// lists than refinements: none in the last ones; those of all ranks (GatherItems). Keeps a reference to the lattice.
  OctantFamilies(const OctreeKeys& lattice, std::vector<std::vector<Index>> requested);

  const OctreeKeys& Lattice() const { return this->TheLattice; }
  int NumberOfRefinements() const { return this->TheLattice.NumberOfRefinements(); }
  /// Keys of the refined families of a level, ascending.
  const std::vector<Index>& Keys(int level) const { return this->Sets[level]; }
  const LevelReport& Report(int level) const { return this->Reports[level]; }

  bool HasFamily(int level, const Index3& family) const;
  /// Whether the family of a cell is refined.
  bool IsRefined(int level, const Index3& cell) const
  {
    return this->HasFamily(level, ParentOfCell(cell));
  }
  /// Bit a set when the cell takes part in pillowing along axis a: it is in the slab of a refined family, and in it or
  /// beside it. The cell must be in the domain.
  int FindSlabs(int level, const Index3& cell) const;
  /// Whether the cell is refined or shares a face or an edge with one that is. False above the finest level.
  bool IsTouched(int level, const Index3& cell) const
  {
    return level < this->NumberOfRefinements() && this->FindSlabs(level, cell) != 0;
  }

private:
  void AddBalance(int level);
  void CloseNonManifoldEdges(int level);

  const OctreeKeys& TheLattice;
  std::vector<std::vector<Index>> Sets;
  std::vector<LevelReport> Reports;
};

} // namespace vfm
