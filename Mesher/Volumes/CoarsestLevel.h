/**
 * CoarsestLevel: the system of the coarsest level of a large island, factored on one rank, its
 * home.
 */
#pragma once

#include "Volumes/IslandLevel.h"

#include <memory>

namespace vfm
{

/// Ways of a level to its home. The ranks must outlive it.
class CoarsestLevel
{
public:
  /// A factorization; empty on other ranks.
  class Factors;

  CoarsestLevel() = default;
  /// @param level  of few groups
  /// @pre Collective.
  explicit CoarsestLevel(const IslandLevel& level);

  /// Factors the system of the level.
  /// @pre Collective.
  std::shared_ptr<const Factors> Factor(const IslandLevel& level, const IslandValues& values) const;
  /// Returns the solution by group of this rank.
  /// @param right  right side by group of this rank
  /// @pre Collective.
  std::vector<double> Solve(const Factors& factors, const std::vector<double>& right) const;

private:
  KeyMerge<Index> Groups;
  KeyMerge<std::array<Index, 2>> Entries; // of the matrix; equal numbers: of its diagonal
};

} // namespace vfm
