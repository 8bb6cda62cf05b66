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
/// @param ids  number over all ranks of each row of surfaces, ascending; of all owned facets
/// @param isShared  whether other ranks have the row too
/// @param[in,out] mesh  mesh with Surfaces and final point positions
/// @pre Collective.
void MeasureSurfaces(const std::vector<int>& ids, const std::vector<unsigned char>& isShared,
  Mesh& mesh, Runtime& runtime);

} // namespace vfm
