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

  /// Replaces the sums of each pair and of each fragment by the sums over all ranks, in the same
  /// messages.
  /// @param fragments  per fragment of this rank; [0] stays
  /// @pre Collective.
  void Sum(std::vector<ExactSum>& pairs, std::vector<ExactSum>& fragments) const;

private:
  std::vector<FragmentPair> ThePairs;
  std::vector<unsigned char> AreMine;
  std::vector<int> Shared;                // pairs that other ranks may have
  std::vector<int> Fragments;             // that other ranks touch
  std::vector<std::size_t> PlacesOfPairs; // of Shared, in the keys of Ways
  std::vector<std::size_t> PlacesOfFragments;
  KeyMerge<std::array<Index, 2>> Ways; // of the shared pairs, and (f, f) for a shared fragment f
};

} // namespace vfm
