/**
 * The geometry that the mesh resolves: volumes, surfaces, curves and vertices.
 *
 * Volume: a fragment. Surface: the quads between two volumes, between a volume and what is not meshed, or on
 * one side of the domain. Curve: the edges where the same surfaces meet. Vertex: a point where curves meet or end.
 * Their numbers are the same on every rank: each learns of all surfaces, curves and vertices.
 * Every mesh point of an owned hex is classified on the lowest-dimensional of them that it lies on.
 */
#pragma once

#include "Fragments.h"
#include "HexTopology.h"
#include "Interface.h"

namespace vfm
{

/// Fills mesh.Fragment, mesh.Surfaces, mesh.GeometryDimension and mesh.GeometryId, and the counts of the report.
void FindGeometry(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& mixed, const Fragments& fragments, const PointNumbering& numbering,
  const Partition& partition, HexMesh& mesh, HexMeshReport& report);

} // namespace vfm
