/**
 * SplitEdges: divides open edges at the corners of other triangles that lie on them.
 */
#pragma once

#include "Surfaces/PatchTriangles.h"

namespace vfm
{

/// Divides triangles so that open edges end at the ends of other open edges that lie on them,
/// within a distance.
/// @return number of triangles that were divided
Index SplitOpenEdges(double distance, PatchTriangles& surface);

} // namespace vfm
