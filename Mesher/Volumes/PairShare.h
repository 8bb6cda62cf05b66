/**
 * PairShare: pairs of fragments that have an interface on a rank, and sums over the ranks that
 * share them.
 */
#pragma once

#include "Labels/FragmentShare.h"

#include <array>

namespace vfm
{

/// Two fragments as numbered on a rank, the lower one first; 0 is the outside.
using FragmentPair = std::array<int, 2>;

/// Pairs of one rank. The ranks of the fragments must outlive it.
class PairShare
{
public:
  PairShare() = default;
  /// @param pairs  ascending, each once
  /// @pre Collective.
  PairShare(const FragmentShare& share, std::vector<FragmentPair> pairs);

  const std::vector<FragmentPair>& Pairs() const { return this->ThePairs; }
  std::size_t Size() const { return this->ThePairs.size(); }
  /// Returns whether this rank counts a pair: the lowest rank that has it does.
  bool IsMine(std::size_t pair) const { return this->AreMine[pair]; }

  /// Replaces the sum of each pair by the sum over all ranks.
  /// @pre Collective.
  void Sum(std::vector<ExactSum>& sums) const;

private:
  std::vector<FragmentPair> ThePairs;
  std::vector<unsigned char> AreMine;
  std::vector<int> Shared; // pairs that other ranks may have
  KeyMerge<std::array<Index, 2>> Ways;
};

} // namespace vfm
