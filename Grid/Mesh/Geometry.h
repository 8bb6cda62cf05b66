/**
 * The geometry that the mesh resolves: volumes, surfaces, curves and vertices.
 *
 * Volume: a fragment. Surface: the facets between two volumes, between a volume and what is not meshed, or on
 * one side of the domain; where an interface has edges, one of its smooth sides. Curve: the edges where the same surfaces meet. Vertex: a point where curves meet or end, or where surfaces
 * touch. A curve, or a surface, may be of several pieces. Their numbers are the same on every rank: each learns of all surfaces, curves
 * and vertices, and of what bounds what.
 * Every mesh point of an owned element is classified on the lowest-dimensional of them that it lies on.
 */
#pragma once

#include "Base/Partition.h"
#include "Mesh/Facet.h"
#include "Mesh/FeatureKind.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"

namespace vfm
{

/// Fills mesh.Surfaces, mesh.Curves, mesh.Vertices, mesh.Tables, mesh.GeometryDimension, mesh.GeometryId of the points on facets (inside
/// volumes they are their fragments), and the counts of the report. kinds: as of FindSmoothSides. mesh: points in their last places.
/// Collective.
void ClassifyGeometry(const std::vector<Facet>& facets, const std::vector<FeatureKind>& kinds,
  const Partition& partition, Mesh& mesh, MeshReport& report);

} // namespace vfm
