/**
 * GatherParticles: prepares particles for writing, as one part per rank or as a whole on rank 0.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/ParticleData.h"

#include <memory>

namespace vfm
{

/// Returns the particles of this rank, ordered by id, with the arrays of all ranks.
/// @param particles  of this rank; null: none
/// @return null if the particles of all ranks are null
/// @throws InputError  if ranks have different arrays; on all ranks
/// @pre Collective
std::shared_ptr<const ParticleData> OrderParticles(const ParticleData* particles, Ranks& ranks);

/// Gathers the particles of all ranks on rank 0, ordered by id. The result does not depend on the
/// number of ranks.
/// @return null if the particles of all ranks are null; no particles on other ranks than 0
/// @throws InputError  if ranks have different arrays or the same id; on all ranks
/// @pre Collective
std::shared_ptr<const ParticleData> GatherParticles(const ParticleData* particles, Ranks& ranks);

/// Returns the number of each particle among those of all ranks, from 0, in the order of ids.
/// @pre Collective
std::vector<Index> NumberParticles(const ParticleData& particles, Ranks& ranks);

/// Returns the first array of particles with a velocity, as IsVelocity of meshes; null: none.
const MeshArray* FindVelocity(const std::vector<MeshArray>& arrays);

/// Returns a mesh of one-node elements at the particles, with their arrays as point arrays.
/// @param[out] nodes  memory of the elements
MeshData ViewAsVertices(const ParticleData& particles, std::vector<Index>& nodes);

} // namespace vfm
