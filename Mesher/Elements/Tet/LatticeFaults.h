/**
 * LatticeFaults: finds where the tets of a lattice do not follow the cells, and the nodes to be
 * settled there.
 *
 * - False facet: an interface between two labels, where no cells of these labels share a face next
 *   to the lattice edge of the tet.
 * - False joint: tets of one label at a face of the grid share a triangle without anchors, but
 *   neither cell at the face has this label, and the cells with it around the face are not
 *   connected.
 * - Non-manifold node: the boundary of a material touches itself (NonManifoldNodes.h).
 *
 * Centres nearby are settled first, then vertices. If all nodes around are settled, the tets follow
 * the cells, whose interfaces are manifold by the label condition.
 */
#pragma once

#include "Elements/Tet/LatticeNodes.h"
#include "Elements/Tet/TetFacets.h"

namespace vfm
{

/// Finds the faults of the tets of owned blocks.
/// @return LatticeNodes::IdOf of nodes to be settled, with repetitions; some may be settled already
std::vector<Index> FindLatticeFaults(const TetTopology& topology, const TetFaces& faces,
  const LatticeNodes& nodes, const CartesianGrid& grid, const Partition& partition);

} // namespace vfm
