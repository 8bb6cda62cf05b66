/**
 * The active part of a tetrahedral mesh: the points that may lie on interfaces and those of the tets around them.
 */
#pragma once

#include "Base/Partition.h"
#include "Smoothing/ActiveMesh.h"
#include "Tet/TetTopology.h"

namespace vfm
{

struct ActiveTets : ActiveMesh
{
  std::vector<Index> MeshElement; ///< of each tet: its index in the mesh
};

/// Points, tets and groups of points, of Cells or Lattice. Collective among peers.
ActiveTets MakeActiveTets(
  const TetTopology& topology, const CartesianGrid& grid, const Partition& partition);

} // namespace vfm
