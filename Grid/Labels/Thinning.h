/**
 * Thinning: makes the sets of thin parts as thin as cells allow (ThinParts.h).
 */
#pragma once

#include "Labels/ThinCandidates.h"

namespace vfm
{

/// What a candidate does: it leaves its set, or stays in it for good.
struct ThinAction
{
  std::size_t Candidate;
  bool Leaves;
};

/// Sends actions to the ranks that have the same cells.
/// @param own  actions of candidates in owned cells
/// @return `own`, and the actions of candidates in ghost cells
/// @pre Collective among peers.
std::vector<ThinAction> ShareActions(const CartesianGrid& grid, const ThinCandidates& candidates,
  const Partition& partition, const std::vector<ThinAction>& own);

/// Removes candidates from the sets until each that is left has to stay.
/// @pre Collective.
void ThinSets(const CartesianGrid& grid, const Partition& partition, Runtime& runtime,
  ThinCandidates& candidates);

} // namespace vfm
