/**
 * FitWalls: moves the walls of a dual mesh so that regions keep the volumes that they have in
 * tetrahedra.
 *
 * A polygon that leaves out its node cuts a corner off. The centres of the triangles of such
 * polygons move along their normals by the same distance everywhere on the surface between two
 * regions, so that the volume between it and the surface of tetrahedra is zero. The borders of
 * surfaces and the sides of the domain do not move.
 */
#pragma once

#include "Meshes/Polyhedra/DualMesh.h"

namespace vfm
{

/// @param[in,out] dual  the points of its walls move; has all points of the walls
/// @return the triangles of surfaces that would have to move too far, and do not
std::vector<Index> FitWalls(const DualTets& tets, const DualWalls& walls, DualMesh& dual);

} // namespace vfm
