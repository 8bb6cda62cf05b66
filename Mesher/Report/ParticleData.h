/**
 * ParticleData: one rank's particles, as input of file writers: material without an element, one
 * particle for each cell or group of cells.
 *
 * It is a view, as MeshData is. The creator owns the memory.
 */
#pragma once

#include "Report/MeshData.h"

namespace vfm
{

/// A view of particles. Pointers to missing arrays are null. Values are in the units of the input,
/// in world coordinates.
struct ParticleData
{
  Index NumberOfParticles = 0;
  const double* Positions = nullptr; ///< shape (NumberOfParticles, 3)
  const Index* Ids = nullptr;        ///< unique over all ranks, at least 0; not consecutive
  const int* Material = nullptr;     ///< ids of the user, as MeshData::Material
  const double* Radius = nullptr;    ///< of the sphere with the volume of the particle
  const double* Volume = nullptr;    ///< of material
  const double* Mass = nullptr;      ///< null without a density
  /// All arrays of files: Id, Material, Radius, Volume, Mass, then state arrays with the names that
  /// they have on elements. Sums over a cell, such as a mass, are sums over a particle.
  std::vector<MeshArray> Arrays;

  Vector3 PositionAt(Index particle) const
  {
    const double* x = this->Positions + 3 * particle;
    return { { x[0], x[1], x[2] } };
  }
};

} // namespace vfm
