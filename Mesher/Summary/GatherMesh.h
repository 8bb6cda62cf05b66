/**
 * GatherMesh: a mesh made ready to be written, as the parts of the ranks or as one on rank 0.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

namespace vfm
{

/// Collective: the mesh; on ranks without elements one with the fields and the arrays, without values, of the first rank
/// that has elements. Throws InputError, on all ranks alike, when none has.
MeshData ShareHead(const MeshData& mesh, Ranks& ranks);

/// Collective: this rank's part with points and elements in the order of their global ids, each once; Time is set, to 0 when no rank
/// has a time; ranks without elements have the head (ShareHead). Views the mesh where it is in order.
/// Throws InputError, on all ranks alike, when the mesh is empty, has no such ids from 1, or has hexahedra on one rank and
/// tetrahedra on another.
StoredMesh OrderMesh(const MeshData& mesh, Ranks& ranks);

/// Collective: on rank 0 the whole mesh, points and elements in the order of their global ids, each once: the same from any number of
/// ranks; with Facets where all parts have them. On other ranks without elements. One rank's mesh that is in order is viewed, not
/// copied; else rank 0 needs the memory of the mesh three times. Throws InputError, on all ranks alike, when ids are missing or parts
/// have different arrays.
StoredMesh GatherMesh(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
