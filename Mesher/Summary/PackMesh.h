/**
 * PackMesh: a mesh as bytes for other ranks.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

namespace vfm
{

/// With all arrays, fields and facets; without the time.
Bytes PackMesh(const MeshData& mesh);
/// The kind of elements, the arrays without values, and the fields.
Bytes PackHead(const MeshData& mesh);
StoredMesh UnpackMesh(const Bytes& bytes);

} // namespace vfm
