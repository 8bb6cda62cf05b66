/**
 * LatticeRules: rules for the labels of lattice nodes, checked before tets are made.
 *
 * - No bridge: an edge between two vertices joins only what the cells join. If both vertices have
 *   one label, one of the four cells around the edge has this label. If they have two labels, a
 *   cell around one of the vertices has the label of the other. Else both vertices are settled.
 * - No break: around a snapped centre, the nodes with the label of its cell are connected, and the
 *   neighbours of the cell with this label are connected to them. Else the centre is settled.
 * - No lost contact: around a snapped centre, nodes with the label of its cell touch the nodes of
 *   each neighbour with another label. They touch if they share an edge, or if they are next to the
 *   same triangle of snapped nodes. The nodes of the neighbour are its centre and the corners of
 *   the common face, as far as they have its label. It suffices that one of the two cells sees the
 *   contact. Else the centre is settled.
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

/// Settles centres until they break no rule.
/// @pre Collective.
void SettleCentres(
  LatticeNodes& nodes, const CartesianGrid& grid, const Partition& partition, Runtime& runtime);

} // namespace vfm
