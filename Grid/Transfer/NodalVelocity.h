/**
 * Velocities of the points of a mesh, for codes that move the points: from those of its elements, so that no momentum is lost.
 *
 * Lumped mass: an element gives each of its corners an equal part of its mass, and of its momentum. A point's velocity is the momentum
 * that it got over the mass. So the momenta of the points sum to those of the elements; kinetic energy is lost (Margolin and Shashkov
 * 2004), in each element what its corners' masses have in moving apart from their points.
 */
#pragma once

#include "Base/Runtime.h"
#include "Mesh/Mesh.h"

namespace vfm
{

struct NodalVelocity
{
  Buffer<double> Velocity; ///< xyz a point; 0 where it has no mass
  Buffer<double> Mass;     ///< of each point, of the elements of all ranks
  Buffer<double> Lost;     ///< >= 0, of each element: kinetic energy that its points do not have
};

/// mesh: of the owned elements; grid: that it was made on. mass: of each element, >= 0; velocity: xyz an element. The same bits on any ranks
/// and threads. Collective.
NodalVelocity FindNodalVelocity(const Mesh& mesh, const CartesianGrid& grid,
  const Buffer<double>& mass, const Buffer<double>& velocity, Runtime& runtime);

/// Of each element the kinetic energy that its cells had and its velocity has not. kinetic: |u|^2 / 2 carried from the cells as
/// velocity was, by mass. Velocities of cells that are joined lose some; below 0 where limiters let these vary more than that.
Buffer<double> FindLostKineticEnergy(const Buffer<double>& mass, const Buffer<double>& velocity,
  const Buffer<double>& kinetic, Runtime& runtime);

} // namespace vfm
