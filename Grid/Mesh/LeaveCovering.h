/**
 * LeaveCovering: ids and partners of the points of a periodic mesh.
 */
#pragma once

#include "Base/Partition.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// Turns a mesh made on a periodic grid into a mesh of the grid of the domain
/// (CartesianGrid::OfDomain): changes ids and Mesh::Levels, and sets Mesh::PeriodicPartner. The
/// order of points and elements stays.
/// @param covering  partition of the periodic grid
/// @param mesh  elements that this rank owns
/// @pre Collective.
void LeaveCovering(const Partition& covering, Mesh& mesh);

} // namespace vfm
