/**
 * NumpyParticles: particles as numpy arrays by name: Position, Id, Material, Radius, Volume, Mass
 * and state.
 */
#pragma once

#include "NumpyArrays.h"
#include "NumpyMesh.h"
#include "Report/ParticleData.h"
#include "State/Particles.h"

namespace vfm
{

/// Makes a dict of particles; state arrays are moved to it. A state array with the name of one of
/// the others is left out.
nanobind::dict TakeParticles(Particles& particles);

/// Views particles in arrays, which must outlive the view.
/// @throws InputError if Position, Id, Material, Radius or Volume is missing, or if an array has
///   another type than TakeParticles gives it, or another length
ParticleData ViewParticles(const NamedArrays& arrays);

} // namespace vfm
