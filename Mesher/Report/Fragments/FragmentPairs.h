/**
 * FragmentPairs: the fragments that share faces, also those of elements on other ranks.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <array>

namespace vfm
{

/// Two different fragments that share a face.
using FragmentPair = std::array<int, 2>;

/// Finds the fragments that share faces with the elements of this rank, also across sides of a
/// periodic domain.
/// @param mesh  with Fragment; faces with a point of GeometryDimension 3 are excluded if known
/// @return pairs with the fragment of an element of this rank first, ascending, each once
/// @throws InputError if PointIds is missing, or if a face belongs to more than two elements of one
/// rank, or to elements of three ranks; on all ranks
/// @pre Collective
/// @note Takes about 60 bytes per face of the surfaces of fragments.
std::vector<FragmentPair> FindFragmentPairs(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
