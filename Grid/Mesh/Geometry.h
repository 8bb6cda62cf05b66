/**
 * The geometry that the mesh resolves: volumes, surfaces, curves and vertices.
 *
 * Volume: a fragment. Surface: the facets between two volumes, between a volume and what is not meshed, or on
 * one side of the domain. Curve: the edges where the same surfaces meet. Vertex: a point where curves meet or end.
 * Their numbers are the same on every rank: each learns of all surfaces, curves and vertices.
 * Every mesh point of an owned element is classified on the lowest-dimensional of them that it lies on.
 */
#pragma once

#include "Base/Partition.h"
#include "Mesh/Facet.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"

namespace vfm
{

/// Fills mesh.Surfaces, mesh.GeometryDimension, mesh.GeometryId of the points on facets (inside volumes they are their fragments),
/// and the counts of the report. Collective.
void ClassifyGeometry(const std::vector<Facet>& facets, const CartesianGrid& grid,
  const Partition& partition, Mesh& mesh, MeshReport& report);

} // namespace vfm
