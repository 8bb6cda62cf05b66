/**
 * Particles: material without an element, one particle per cell and material, or per group of
 * cells (Transfer/JoinRows.h). Elements and particles together hold the contents of all cells.
 */
#pragma once

#include "Report/ParticleData.h"
#include "State/TransferredArray.h"

#include <vector>

namespace vfm
{

/// Particles of one rank, each on one rank only; ascending by cell and material.
struct Particles
{
  std::vector<double> Positions; ///< (particles, 3); a particle of one cell is at its centre
  std::vector<Index> Ids;        ///< from the cell and the material, equal on any ranks
  std::vector<int> Material;
  std::vector<double> Radius, Volume;
  std::vector<double> Mass;             ///< empty without a density
  std::vector<TransferredArray> Arrays; ///< state, as of elements
  bool HasMass = false;                 ///< true with a density, also if this rank has no particle

  Index Size() const { return static_cast<Index>(this->Ids.size()); }
};

/// Returns a view of particles with their arrays. A state array that is named like one of Id,
/// Material, Radius, Volume and Mass replaces it in the list.
/// @param particles  must outlive the result
ParticleData ViewParticles(const Particles& particles);

} // namespace vfm
