/**
 * Where the boundary of a material in a Lattice mesh touches itself.
 */
#pragma once

#include "Tet/TetFacets.h"

namespace vfm
{

/// Ids of the snapped nodes at the points of owned blocks around which the boundary of some meshed material is not
/// one fan of triangles, and at the other ends of edges there that are not on two triangles of it.
std::vector<Index> FindNonManifoldNodes(
  const TetTopology& topology, const CartesianGrid& grid, const Partition& partition);

} // namespace vfm
