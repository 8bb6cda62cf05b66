/**
 * MeasureSurfaces: areas, centroids and mean normals of surfaces.
 */
#pragma once

#include "Mesh/Mesh.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Fills SurfaceAreas, SurfaceCentroids and SurfaceNormals of mesh.Tables. A quad
/// counts as two triangles.
/// @param[in,out] mesh  mesh with Surfaces and final point positions
/// @pre Collective.
void MeasureSurfaces(Mesh& mesh, Ranks& ranks);

} // namespace vfm
