/**
 * PairSums: sums over the interfaces between pairs of fragments or materials, equal on all ranks,
 * and the shifts of these interfaces that correct the volumes of all items.
 */
#pragma once

#include "Base/ExactSum.h"

#include <map>
#include <utility>
#include <vector>

namespace vfm
{

/// Sum over the interface between two items.
struct PairSum
{
  int First, Second; ///< numbers of the items, First < Second
  ExactSum Value;
};
/// Sums of this rank by (First, Second).
using PairSumMap = std::map<std::pair<int, int>, ExactSum>;

/// Returns the sums over all ranks, sorted by pair.
/// @pre Collective over `ranks`.
std::vector<PairSum> GatherPairSums(const PairSumMap& mine, Ranks& ranks);

/// Added to the diagonal of the systems of mu: it keeps items without sums regular.
constexpr double RegularDiagonal = 1e-6;

/// Solves sum_b S_ab (mu_a - mu_b) = lack_a for all items a >= 1, with mu_0 = 0.
/// @param sums  S_ab >= 0: the amount that item a gains from item b if mu_a grows by 1
/// @param lack  missing amount per item; lack[0] is not used
/// @return mu per item; near lack / 1e-6 for items without sums
std::vector<double> SolveForLack(const std::vector<PairSum>& sums, const std::vector<double>& lack);

} // namespace vfm
