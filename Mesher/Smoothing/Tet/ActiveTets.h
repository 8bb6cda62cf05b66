/**
 * ActiveTets: the part of a tetrahedral mesh that smoothing moves. These are the points that may
 * lie on interfaces, and all points of the tets around them.
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Tet/TetTopology.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Returns the active part of a mesh of method Cells or Lattice, without attachments.
/// @param mesh  tets in CartesianGrid::HexBox of the grid
/// @param positions  TetTopology::Positions
/// @param isThin  FindThinFragments
/// @pre Collective among peers.
ActiveMesh MakeActiveTets(const Mesh& mesh, const std::vector<PointPosition>& positions,
  const BarrierElements& barrier, const std::vector<unsigned char>& isThin,
  const CartesianGrid& grid, const Partition& partition, Runtime& runtime);

} // namespace vfm
