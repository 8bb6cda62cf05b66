/**
 * RepeatedTriangles: drops triangles with the same corners as others.
 */
#pragma once

#include "Surfaces/PatchTriangles.h"

namespace vfm
{

/// Numbers of triangles that were dropped.
struct DroppedTriangles
{
  Index Repeated = 0;   ///< all but one of triangles with the same corners
  Index BackToBack = 0; ///< all triangles with the same corners
};

/// Keeps one of the triangles with the same corners, or none: each edge must then have an even
/// number of triangles. If both ways do, one is kept unless as many of them turn one way as the
/// other.
DroppedTriangles DropRepeated(PatchTriangles& surface);

} // namespace vfm
