/**
 * PackMesh: packs a mesh into a message for other ranks.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Packs all arrays, fields and facets, but not the time.
Bytes PackMesh(const MeshData& mesh);
/// Packs the kind of elements, the arrays without values, and the fields.
Bytes PackHead(const MeshData& mesh);
/// Unpacks the result of PackMesh or PackHead.
StoredMesh UnpackMesh(const Bytes& bytes);

} // namespace vfm
