/**
 * GatherMesh: prepares a mesh for writing, as one part per rank or as a whole on rank 0.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Returns the mesh; on ranks without elements, an empty mesh with the fields of the first rank
/// that has elements, and its arrays without values.
/// @throws InputError if no rank has elements, on all ranks
/// @pre Collective
MeshData ShareHead(const MeshData& mesh, Ranks& ranks);

/// Returns the part of this rank, points and elements ordered by global id, each once.
/// Views the mesh if it is ordered already. Sets Time, to 0 if no rank has a time. Ranks without
/// elements get the head (ShareHead).
/// @throws InputError if the mesh is empty, has no ids from 1, or has hexahedra on one rank and
/// tetrahedra on another; on all ranks
/// @pre Collective
StoredMesh OrderMesh(const MeshData& mesh, Ranks& ranks);

/// Gathers the whole mesh on rank 0, points and elements ordered by global id, each once.
/// The result does not depend on the number of ranks. It has Facets if all parts have them.
/// @return the whole mesh on rank 0, no elements on other ranks
/// @throws InputError if ids are missing, or parts have different arrays; on all ranks
/// @pre Collective
/// @note An ordered mesh of a single rank is viewed, not copied. Otherwise rank 0 needs the memory
/// of the mesh three times.
StoredMesh GatherMesh(const MeshData& mesh, Ranks& ranks);

/// Sends bytes to rank 0.
/// @return on rank 0 the bytes of ranks 1, 2, ..; none on other ranks
/// @pre Collective
std::vector<Bytes> SendToFirst(Bytes mine, Ranks& ranks);

} // namespace vfm
