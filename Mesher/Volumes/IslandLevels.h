/**
 * IslandLevels: an approximate solver for the system of a large island, from levels of ever larger
 * groups of its fragments (algebraic multigrid by aggregation).
 *
 * A group has about 8 members of the level below. Its unknown is a shift that all members have in
 * common. Each level but the coarsest first and last corrects each unknown by itself (Jacobi), and
 * between these corrects the groups. Their system is solved by two steps of conjugate gradients,
 * each with the levels above as its approximate solver (Notay, Vassilevski 2008). So the number of
 * iterations hardly grows with the number of fragments.
 */
#pragma once

#include "Volumes/CoarsestLevel.h"

namespace vfm
{

/// Levels of one island. All sums are exact.
class IslandLevels
{
public:
  IslandLevels() = default;
  /// Finds groups from the areas.
  /// @param first  the fragments
  /// @param areas  by pair, over all ranks
  /// @pre Collective.
  IslandLevels(IslandLevel first, const std::vector<double>& areas);

  const IslandLevel& First() const { return this->Levels[0]; }

  /// Values of all levels, and factors of the coarsest.
  struct System
  {
    std::vector<IslandValues> Values;
    std::shared_ptr<const CoarsestLevel::Factors> Factors;
  };
  /// @param areas  by pair of the fragments, over all ranks
  /// @pre Collective.
  System MakeSystem(std::vector<double> areas) const;

  /// Returns an approximate solution by fragment of this rank.
  /// @param right  right side by fragment of this rank; [0] is 0
  /// @pre Collective.
  std::vector<double> Approximate(const System& system, const std::vector<double>& right) const
  {
    return this->Cycle(system, 0, right);
  }

private:
  bool IsCoarse(std::size_t level) const;
  std::vector<double> Cycle(
    const System& system, std::size_t level, const std::vector<double>& right) const;
  std::vector<double> CycleTwice(
    const System& system, std::size_t level, const std::vector<double>& right) const;

  std::vector<IslandLevel> Levels;
  CoarsestLevel Coarsest;
};

} // namespace vfm
