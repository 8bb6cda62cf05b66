/**
 * FindIslands: the islands of fragments, which are connected by interfaces between fragments.
 */
#pragma once

#include "Volumes/PairShare.h"

namespace vfm
{

/// Islands of the fragments of a rank. Arrays have one entry per fragment, [0] unused.
struct Islands
{
  std::vector<int> Lowest;              ///< lowest fragment of the island, by its number over all
  std::vector<Index> Sizes;             ///< number of fragments of the island, over all ranks
  std::vector<unsigned char> AreShared; ///< whether other ranks may have fragments of the island
  int Rounds = 0;                       ///< of messages between ranks; grows with log2 P
};

/// Finds the islands. The outside connects no fragments.
/// @param pairs  of fragments of this rank with an interface; those with 0 do not count
/// @pre Collective.
Islands FindIslands(const FragmentShare& share, const std::vector<FragmentPair>& pairs);

} // namespace vfm
