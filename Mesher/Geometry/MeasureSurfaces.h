/**
 * MeasureSurfaces: areas, centroids and mean normals of surfaces.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Fills SurfaceAreas, SurfaceCentroids and SurfaceNormals of mesh.Tables. A quad
/// counts as two triangles.
/// @param[in,out] mesh  mesh with Surfaces and final point positions
/// @pre Collective.
void MeasureSurfaces(Mesh& mesh, Runtime& runtime);

} // namespace vfm
