/**
 * MeshDigest: one number that tells meshes apart, whichever ranks hold their elements.
 */
#pragma once

#include "Elements/Mesh.h"

namespace vfm
{
namespace testing
{

/// Returns a digest of the elements, their points, facets, curves and vertices of one rank, with
/// ids over all ranks. The digest of a mesh is the sum over its ranks.
std::uint64_t DigestOfRank(const Mesh& mesh);

} // namespace testing
} // namespace vfm
