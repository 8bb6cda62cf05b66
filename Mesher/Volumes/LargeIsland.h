/**
 * LargeIsland: the system of the shifts of one island of many fragments, solved by conjugate
 * gradients. Its ranks solve it together. All sums are exact, so the solution has the same bits on
 * any number of ranks.
 */
#pragma once

#include "Volumes/IslandLevels.h"

namespace vfm
{

/// One island. Ranks without a fragment of it take part, with an empty share.
class LargeIsland
{
public:
  /// Part of the lacks that may remain: sums of squares over the fragments, relative.
  static constexpr double Tolerance = 1e-6;

  LargeIsland() = default;
  /// @param share  the fragments of the island on this rank
  /// @param pairs  of these fragments
  /// @param areas  by pair, over all ranks; later areas may differ
  /// @pre Collective.
  LargeIsland(
    FragmentShare share, std::vector<FragmentPair> pairs, const std::vector<double>& areas);

  /// Solves sum_b A_ab (mu_a - mu_b) + 1e-6 mu_a = lack_a, with mu_0 = 0.
  /// @param areas  by pair, over all ranks
  /// @param lack  by fragment of this rank; [0] is not used
  /// @param[out] iterations  number of iterations
  /// @return mu by fragment of this rank; [0] is 0
  /// @pre Collective.
  std::vector<double> Solve(const std::vector<double>& areas, const std::vector<double>& lack,
    int* iterations = nullptr) const;

private:
  IslandLevels Levels;
};

} // namespace vfm
