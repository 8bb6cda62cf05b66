/**
 * Intersections: finds facets next to void that is not meshed which pass through each other. The
 * elements between such facets are positive, so bodies, or parts of one body, overlap only where
 * their facets intersect. (A body that is wholly inside another one would have no intersections,
 * but it would have to move through all of the void around it.)
 *
 * A quad is the four triangles around the mean of its corners. All facets of all ranks are
 * compared, whatever their distance was before points moved.
 */
#pragma once

#include "Base/Runtime.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Returns flags of the points of facets that intersect others, for all points. The flags of points
/// that this rank moves are complete; it does not know all flags of ghosts.
/// @param mesh  with facets and current positions
/// @pre Collective.
std::vector<unsigned char> FindIntersections(const ActiveMesh& mesh, Runtime& runtime);

} // namespace vfm
