/**
 * Areas, centroids and mean normals of the surfaces of a mesh.
 */
#pragma once

#include "Mesh/Mesh.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Fills SurfaceAreas, SurfaceCentroids and SurfaceNormals of mesh.Tables; quads are two triangles. mesh: with Surfaces, points in their last
/// places. Collective.
void MeasureSurfaces(Mesh& mesh, Ranks& ranks);

} // namespace vfm
