/**
 * MoveTetPoints: moves the points in tetrahedra so that cells have better faces.
 *
 * They are on no wall, so that regions keep their volumes.
 */
#pragma once

#include "Meshes/Polyhedra/DualMesh.h"

namespace vfm
{

/// Moves the points in the tetrahedra at poor faces (DualMeasures.h), one after the other, as long
/// as the faces around them become better.
/// @param[in,out] dual  its first points are those in the tetrahedra
void MoveTetPoints(const DualTets& tets, DualMesh& dual);

} // namespace vfm
