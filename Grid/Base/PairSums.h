/**
 * Sums over the interfaces of pairs (of fragments, of materials), the same on all ranks, and what moves these interfaces
 * so that both sides get what they lack.
 */
#pragma once

#include "Base/ExactSum.h"

#include <map>
#include <utility>
#include <vector>

namespace vfm
{

struct PairSum
{
  int First, Second; ///< the smaller first
  ExactSum Value;
};
using PairSumMap = std::map<std::pair<int, int>, ExactSum>;

/// The sums over all ranks, sorted by their pairs. Collective.
std::vector<PairSum> GatherPairSums(const PairSumMap& mine, Ranks& ranks);

/// Solves sum_b S_ab (mu_a - mu_b) = lack_a for all a from 1, with mu = 0 for 0. S_ab >= 0: what a gains of b when mu_a grows by 1.
/// lack: [0] unused. Items without sums get mu near lack / 1e-6.
std::vector<double> SolveForLack(const std::vector<PairSum>& sums, const std::vector<double>& lack);

} // namespace vfm
