/**
 * Particles made by hand, for tests of their files.
 */
#pragma once

#include "Report/ParticleData.h"

namespace vfm
{
namespace testing
{

/// The particles of one rank, with their memory.
struct ParticleCase
{
  std::vector<double> Positions, Radius, Volume, Mass, Velocity, Energy, Stress;
  std::vector<Index> Ids;
  std::vector<int> Material;
  ParticleData Data;
};

/// Returns one rank's share of particles of materials 1 and 3, in no order of ids. Volumes extend
/// over six powers of ten, densities and velocities over three. State: velocity, energy, and six
/// stresses. The first particle has the least coordinates of the domain.
/// @param domain  bounds of the positions: x_min x_max y_min y_max z_min z_max
/// @param ranks  1: all particles
ParticleCase MakeParticles(
  Index count, const std::vector<double>& domain, int rank, int ranks, bool hasMass = true);

} // namespace testing
} // namespace vfm
