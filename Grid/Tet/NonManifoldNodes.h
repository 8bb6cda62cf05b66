/**
 * Where the boundary of a material in a Lattice mesh touches itself.
 */
#pragma once

#include "Base/Partition.h"
#include "Tet/TetFacets.h"

namespace vfm
{

/// The boundary of a material is a manifold where the triangles around each of its points form one fan, closed or ended by
/// sides of the domain, and each edge has two of them. Looks at the points of owned blocks. Returns the ids of the snapped
/// nodes that break the rule: points with no fan, and other ends of edges with another number of triangles.
std::vector<Index> FindNonManifoldNodes(const TetTopology& topology, const TetFaces& faces,
  const CartesianGrid& grid, const Partition& partition);

} // namespace vfm
