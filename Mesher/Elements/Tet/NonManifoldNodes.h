/**
 * NonManifoldNodes: finds where the boundary of a material in a Lattice mesh touches itself.
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Tet/TetFacets.h"

namespace vfm
{

/// Returns the snapped nodes at which the boundary of a material is not a manifold. The boundary of
/// a material, with its faces on sides of the domain, is a manifold if each edge has two triangles
/// and the triangles around each point form one closed fan. Checks the points of owned blocks.
/// @return ids of snapped nodes, ascending: points whose triangles form no such fan, and other ends
/// of their edges that do not have two triangles
std::vector<Index> FindNonManifoldNodes(const TetTopology& topology, const TetFaces& faces,
  const CartesianGrid& grid, const Partition& partition);

} // namespace vfm
