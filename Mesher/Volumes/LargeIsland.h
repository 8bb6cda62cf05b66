/**
 * LargeIsland: the system of the shifts of one island of many fragments, solved by conjugate
 * gradients. Its ranks solve it together. All sums are exact, so the solution has the same bits on
 * any number of ranks.
 */
#pragma once

#include "Volumes/PairShare.h"

namespace vfm
{

/// One island. Ranks of its share without a fragment of it take part.
class LargeIsland
{
public:
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
  /// @return mu by fragment of this rank
  /// @pre Collective.
  std::vector<double> Solve(const std::vector<double>& areas, const std::vector<double>& lack,
    int* iterations = nullptr) const;

private:
  FragmentShare Share;
  PairShare Pairs;
};

} // namespace vfm
