/**
 * OctetSets: which cells of each level are refined. Cells are refined in octets, 2x2x2 cells of a level (RefinedLattice.h).
 *
 * The sets are closed, so that refinement makes a mesh:
 *   margin  an octet of level l + 1, which is a cell of level l, and the 18 cells that share a face or an edge with it lie
 *           in refined octets of level l;
 *   pinch   two refined octets on the diagonal of 3x3 octets of a plane have a third among the five that surround the
 *           diagonal's middle. Otherwise their rings of transition hexes would touch along an edge only.
 * Closing goes from the finest level down. Octets are added in rounds, each from the sets of the round before, so the
 * result does not depend on any order. After Owen, Shih, Ernst (2017) in substance; the pinch rule was found by testing.
 *
 * Memory follows the refined octets: a sorted list of keys a level.
 */
#pragma once

#include "Octree/RefinedLattice.h"

namespace vfm
{

class OctetSets
{
public:
  struct LevelReport
  {
    Index Wanted = 0;  ///< octets asked for
    Index Margin = 0;  ///< added because the next level needs them
    Index Pinches = 0; ///< added by the pinch rule
    int Rounds = 0;    ///< in which the pinch rule added some
  };

  /// wanted: of each refinement, the keys of octets (RefinedLattice::OctetKey) in any order, repeated or not; fewer
  /// lists than refinements: none in the last ones; those of all ranks (GatherItems). Keeps a reference to the lattice.
  OctetSets(const RefinedLattice& lattice, std::vector<std::vector<Index>> wanted);

  const RefinedLattice& Lattice() const { return this->TheLattice; }
  int NumberOfRefinements() const { return this->TheLattice.NumberOfRefinements(); }
  /// Keys of the refined octets of a level, ascending.
  const std::vector<Index>& Keys(int level) const { return this->Sets[level]; }
  const LevelReport& Report(int level) const { return this->Reports[level]; }

  bool HasOctet(int level, const Index3& octet) const;
  /// Whether the octet of a cell is refined.
  bool IsRefined(int level, const Index3& cell) const
  {
    return this->HasOctet(level, { { cell[0] >> 1, cell[1] >> 1, cell[2] >> 1 } });
  }
  /// Bit a set when the cell takes part in pillowing along axis a: it is in the slab of a refined octet, and in it or
  /// beside it. The cell must be in the domain.
  int FindSlabs(int level, const Index3& cell) const;
  /// Whether the cell is refined or shares a face or an edge with one that is. False above the finest level.
  bool IsTouched(int level, const Index3& cell) const
  {
    return level < this->NumberOfRefinements() && this->FindSlabs(level, cell) != 0;
  }

private:
  void AddMargin(int level);
  void ClosePinches(int level);

  const RefinedLattice& TheLattice;
  std::vector<std::vector<Index>> Sets;
  std::vector<LevelReport> Reports;
};

} // namespace vfm
