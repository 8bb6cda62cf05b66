/**
 * FoamCloud: writes particles as a cloud of OpenFOAM.
 *
 * The cloud "particles" is in 0/lagrangian: positions, d (diameter), nParticle (1), U if particles
 * have velocities, and rho if they have masses. The
 * cell of a position is -1: OpenFOAM looks for it. 0/uniform/lagrangian has the dictionary that
 * tells that positions are given. All files are text, also in binary cases.
 */
#pragma once

#include "Meshes/Files/OutputSet.h"
#include "Report/ParticleData.h"

#include <string>

namespace vfm
{

/// @param folder  of the case, or of a part of it
void WriteCloud(const ParticleData& particles, const std::string& folder, OutputSet& files);

} // namespace vfm
