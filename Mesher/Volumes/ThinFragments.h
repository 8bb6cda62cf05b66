/**
 * ThinFragments: the fragments that have thin parts (Labels/ThinParts.h).
 */
#pragma once

#include "Elements/Mesh.h"
#include "Labels/FragmentShare.h"

namespace vfm
{

/// Returns whether each fragment of this rank has an element in a thin cell on any rank; [0] is
/// that of elements outside of fragments. Empty on all ranks if there are no thin cells.
/// @param thin  thin cells of this rank, ascending
/// @param share  the fragments of this rank, whose numbers the elements have
/// @pre Collective.
std::vector<unsigned char> FindThinFragments(const CartesianGrid& grid, const Mesh& mesh,
  const std::vector<Index>& thin, const FragmentShare& share);

} // namespace vfm
