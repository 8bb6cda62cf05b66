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
  /// @param fragments  fragments of the share whose sums travel with those of pairs: all that are
  ///   shared, or none
  /// @pre Collective.
  PairShare(const FragmentShare& share, std::vector<FragmentPair> pairs,
    const std::vector<int>& fragments = {});

  const std::vector<FragmentPair>& Pairs() const { return this->ThePairs; }
  std::size_t Size() const { return this->ThePairs.size(); }
  /// Returns whether this rank counts a pair: the lowest rank that has it does.
  bool IsMine(std::size_t pair) const { return this->AreMine[pair]; }

  /// Replaces the sums of each pair, and of the fragments of the constructor, by the sums over all
  /// ranks, in the same messages.
  /// @param fragments  per fragment of this rank; not used without fragments in the constructor
  /// @pre Collective.
  void Sum(std::vector<ExactSum>& pairs, std::vector<ExactSum>& fragments) const;
  /// Does the same for pairs. @pre There are no fragments in the constructor. Collective.
  void Sum(std::vector<ExactSum>& pairs) const;

private:
  std::vector<FragmentPair> ThePairs;
  std::vector<unsigned char> AreMine;
  /// In the order of the keys of Ways: a pair p that other ranks may have, or ~f for a fragment f.
  std::vector<int> Items;
  KeyMerge<std::array<Index, 2>> Ways; // a fragment f has the key (f, f)
};

} // namespace vfm
