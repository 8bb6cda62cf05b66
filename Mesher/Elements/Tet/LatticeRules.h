/**
 * LatticeRules: rules for the labels of lattice nodes, checked before tets are made.
 *
 * - No bridge: an edge between two vertices joins only what the cells join. If both vertices have
 *   one label, one of the four cells around the edge has this label. If they have two labels, a
 *   cell around one of the vertices has the label of the other. Else both vertices are settled.
 * - No break: for a snapped centre, the nodes around it with the label of its cell stand for the
 *   cell. They are connected near the cell (LatticeNear.h), and so are those of the neighbours of
 *   the cell with this label. Else the centre is settled.
 * - No lost contact: near a snapped centre, nodes connected to those of its cell touch nodes
 *   connected to those of each neighbour with another label. They touch if they share an edge, or
 *   if they are next to the same triangle of snapped nodes. It suffices that one of the two cells
 *   sees the contact. Else the centre is settled.
 * - No snapped tet: if all nodes of a lattice tet are snapped, one of its centres is settled. Then
 *   each tet of the mesh has a node that is inside its material and the domain.
 *
 * Diagonals on the domain boundary need no rule, because only pure vertices have labels there.
 */
#pragma once

#include "Elements/Tet/LatticeNodes.h"

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
