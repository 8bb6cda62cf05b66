/**
 * LeaveCovering: ids and partners of the points of a periodic mesh.
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Which copy of a point PeriodicPartner names.
enum class Partner
{
  Lowest, ///< the copy with the lowest id in the mesh
  Upper   ///< the copy on upper sides, which may not be in the mesh; for JoinCopies
};

/// Turns a mesh made on a periodic grid into a mesh of the grid of the domain
/// (CartesianGrid::OfDomain): changes ids and Mesh::Levels, and sets Mesh::PeriodicPartner. The
/// order of points and elements stays. Tets between free sides have points with ids below 1, which
/// JoinCopies replaces.
/// @param covering  partition of the periodic grid
/// @param mesh  elements that this rank owns
/// @pre Collective.
void LeaveCovering(const Partition& covering, Partner partner, Mesh& mesh);

} // namespace vfm
