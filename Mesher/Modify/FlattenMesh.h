/**
 * FlattenMesh: quads or triangles of a plane from a layer of prisms.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/FlatMesh.h"

namespace vfm
{

/// Replaces hexes of a layer of one cell, prisms with straight columns of points (FlatColumns.h),
/// by their lower faces, counterclockwise seen from above. Facets, curves and vertices of the mesh
/// become those of the plane; there are no surfaces. Points inside fragments have the dimension 2.
/// A triangle of element e has the id 2 e - 1 or 2 e. Quality is not measured.
/// @param axis  across the layer
/// @return old number of each point
std::vector<Index> FlattenMesh(int axis, FlatElement kind, Runtime& runtime, Mesh& mesh);

} // namespace vfm
