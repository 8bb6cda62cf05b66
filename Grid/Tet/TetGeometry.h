/**
 * Surfaces and classification of a tetrahedral mesh.
 */
#pragma once

#include "Mesh/Geometry.h"
#include "Tet/TetFacets.h"

namespace vfm
{

/// Fills mesh.Surfaces, mesh.GeometryDimension and mesh.GeometryId from mesh.Fragment, and the counts of the report. Collective.
void FindTetGeometry(const TetFaces& faces, const CartesianGrid& grid, const Partition& partition,
  Mesh& mesh, MeshReport& report);

} // namespace vfm
