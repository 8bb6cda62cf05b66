/**
 * LatticeRules: rules for the labels of lattice nodes, checked before tets are made.
 *
 * - No bridge: an edge between two vertices joins only what the cells join. If both vertices have
 *   one label, one of the four cells around the edge has this label. If they have two labels, a
 *   cell around one of the vertices has the label of the other. Else both vertices are settled.
 * - No break: around a snapped centre, the nodes with the label of its cell are connected, and the
 *   neighbours of the cell with this label are connected to them. Else the centre is settled.
 * - No snapped tet: if all nodes of a lattice tet are snapped, one of its centres is settled, the
 *   one whose cell has the larger fraction of its own label. Then each tet of the mesh has a node
 *   that is inside its material and the domain.
 *
 * Diagonals on the domain boundary need no rule, because only pure vertices have labels there.
 */
#pragma once

#include "Tet/LatticeNodes.h"

namespace vfm
{

/// Settles vertices at bridges.
/// @pre Collective.
void SettleBridges(
  LatticeNodes& nodes, const CartesianGrid& grid, const Partition& partition, Runtime& runtime);

/// Settles centres, until no cell is broken and no tet is snapped.
/// @pre Collective.
void SettleCentres(
  LatticeNodes& nodes, const CartesianGrid& grid, const Partition& partition, Runtime& runtime);

} // namespace vfm
