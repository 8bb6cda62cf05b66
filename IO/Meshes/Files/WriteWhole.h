/**
 * WriteWhole: gathers the mesh of all ranks and writes it on rank 0.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <functional>

namespace vfm
{

/// Calls write(whole) on rank 0. The whole mesh does not depend on the number of ranks: points and
/// elements are ordered by global id, each once. It has its known arrays and those for which
/// isTaken(array) is true, and the particles of all ranks, ordered by id.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @throws InputError  if the mesh is empty or lacks a required array, or if write does; on all
///   ranks
/// @pre Collective
/// @note Rank 0 needs the memory of GatherMesh.
void WriteWhole(const MeshData& mesh, Ranks& ranks,
  const std::function<void(const MeshData&)>& write,
  const std::function<bool(const MeshArray&)>& isTaken = {});

} // namespace vfm
