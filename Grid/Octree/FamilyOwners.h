/**
 * FamilyOwners: the ranks that own the families of a refined grid, and the exchange of families
 * between owners and the ranks that read them.
 *
 * A family belongs to the rank that owns its first cell, the one with the lowest indices. On a
 * periodic grid, a family outside the domain is a copy, and the owner of the family in the domain
 * sends it like a ghost cell.
 */
#pragma once

#include "Base/Partition.h"
#include "Octree/OctreeKeys.h"

namespace vfm
{

/// Owners of families around one rank. The lattice and the ranks must outlive it.
class FamilyOwners
{
public:
  /// @param part  base cells around which this rank reads families; contains the owned ones
  /// @param layers  number of layers of base cells around `part` in which it reads them
  /// @param requested  keys of families for each refinement, which ToOwners sends
  /// @param halvings  keys[i] are of level i + halvings (OctreeKeys::FamilyKey)
  /// @pre Collective over `ranks`.
  FamilyOwners(const OctreeKeys& lattice, const IndexBox& part, Index layers,
    const std::vector<std::vector<Index>>& requested, int halvings, Ranks& ranks);
  FamilyOwners(const FamilyOwners&) = delete;
  FamilyOwners& operator=(const FamilyOwners&) = delete;

  /// Returns whether this rank owns a family of a level.
  bool Owns(int level, const Index3& family) const;
  /// Returns the families of a level that this rank owns among those that it and its peers pass.
  /// @param keys  of a list of the constructor, in any order, possibly repeated
  /// @return keys, ascending
  /// @pre Collective among peers.
  std::vector<Index> ToOwners(int level, const std::vector<Index>& keys) const;
  /// Returns the owned families of a level and those that peers own.
  /// @param owned  keys of owned families, ascending
  /// @param near  cells of the level: families of peers elsewhere are left out
  /// @return keys, ascending
  /// @pre Collective among peers.
  std::vector<Index> WithGhosts(
    int level, const std::vector<Index>& owned, const IndexBox& near) const;

private:
  Index3 NearestCopy(int level, const Index3& cell) const;
  Index DistanceOf(int level, const Index3& cell) const;
  Index FindLayers(const IndexBox& part, Index layers,
    const std::vector<std::vector<Index>>& requested, int halvings, Ranks& ranks) const;

  const OctreeKeys& Lattice;
  CartesianGrid Window; // the base grid, with ghost cells where this rank reads families
  Partition Parts;
};

} // namespace vfm
