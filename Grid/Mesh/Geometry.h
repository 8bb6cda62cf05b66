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
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"

namespace vfm
{

/// A face of elements on a surface.
struct Facet
{
  std::array<Index, 4> Points; ///< of the mesh; three in triangles
  std::array<int, 2>
    Sides; ///< fragments, the smaller first; 0 not meshed, -1 - side beyond a side of the domain
  std::array<int, 2>
    Materials;    ///< the smaller first; the normal points from the second to the first
  int DomainSide; ///< -1, or 0..5
  bool IsOwned;   ///< this rank writes it
};

/// Fills mesh.Surfaces, GeometryDimension and GeometryId of the points on facets, and the counts of the report.
/// Collective.
void ClassifyGeometry(const std::vector<Facet>& facets, const CartesianGrid& grid,
  const Partition& partition, Mesh& mesh, MeshReport& report);

} // namespace vfm
