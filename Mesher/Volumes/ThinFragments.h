/**
 * ThinFragments: the fragments that have thin parts (Labels/ThinParts.h).
 */
#pragma once

#include "Elements/Mesh.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Returns whether each fragment has an element in a thin cell, [0] unused; empty if none has.
/// @param thin  thin cells of this rank, ascending
/// @param fragments  number of fragments over all ranks
/// @pre Collective.
std::vector<unsigned char> FindThinFragments(const CartesianGrid& grid, const Mesh& mesh,
  const std::vector<Index>& thin, Index fragments, Ranks& ranks);

} // namespace vfm
