/**
 * OrientTriangles: turns triangles so that neighbours face the same side.
 */
#pragma once

#include "Surfaces/SurfaceEdges.h"

namespace vfm
{

/// Triangles of a surface as connected components.
struct SurfaceParts
{
  std::vector<Index> Part;    ///< component of each triangle, from 0 by the first triangle
  std::vector<bool> IsTurned; ///< whether a triangle must be turned to face as the first one does
  Index Count = 0;
};

/// Finds the components, joined by edges. Around an edge of more than two triangles, the solid and
/// the space outside alternate.
/// @param sides  sides of the triangles; each edge has an even number
/// @throws InputError  if a component has only one side, as a Moebius strip has
SurfaceParts FindParts(const PatchTriangles& surface, const std::vector<TriangleSide>& sides);

} // namespace vfm
