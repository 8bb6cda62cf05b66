/**
 * NodalVelocity: velocities of mesh points for codes with moving points. They are computed from the
 * velocities of the elements and conserve momentum.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Result of FindNodalVelocity.
struct NodalVelocity
{
  Buffer<double> Velocity; ///< (points, 3); 0 if a point has no mass
  Buffer<double> Mass;     ///< (points), summed over the elements of all ranks
  Buffer<double> Lost;     ///< (elements), kinetic energy that the points lack, >= 0
};

/// Returns velocities of mesh points that conserve the momentum of the elements.
/// Lumped mass: each element adds an equal share of its mass and momentum to each of its corners.
/// The velocity of a point is its momentum over its mass. Kinetic energy decreases: an element
/// loses the energy of its corner masses relative to their points. L. G. Margolin and M. Shashkov,
/// Computer Methods in Applied Mechanics and Engineering 193 (2004) 4139-4155.
/// @param mesh  elements owned by this rank, points in their final position
/// @param grid  grid that the mesh was made on; determines which rank owns a point
/// @param mass  mass of each element, >= 0
/// @param velocity  velocity of each element (elements, 3), row-major
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks and threads. Takes one gather and two
/// exchanges with neighbours.
NodalVelocity FindNodalVelocity(const Mesh& mesh, const CartesianGrid& grid,
  const Buffer<double>& mass, const Buffer<double>& velocity, Runtime& runtime);

/// Returns the kinetic energy that the cells of each element had and its velocity lacks.
/// Differences within rounding are 0. A transfer of first order averages velocities, so its result
/// is >= 0. A transfer of second order gives elements the variation of velocity inside cells, which
/// the kinetic energy of the cells does not contain: the result is negative where elements are not
/// larger than cells, and its sum may be.
/// @param mass  mass of each element
/// @param velocity  transferred velocity (elements, 3), row-major
/// @param kinetic  |u|^2 / 2 of the cells, transferred per mass like velocity (elements)
Buffer<double> FindLostKineticEnergy(const Buffer<double>& mass, const Buffer<double>& velocity,
  const Buffer<double>& kinetic, Runtime& runtime);

} // namespace vfm
