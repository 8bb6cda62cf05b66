/**
 * AddMidNodes: turns a mesh of linear elements into one of second-order elements.
 *
 * Mid nodes of interface edges lie on the curved interface (EdgePulls.h), as far as the elements
 * there stay positive (StraightenEdges.h). All other edges are straight. Mid nodes of faces and
 * centres follow from the edges by the shape functions of the element without these nodes, so an
 * element of 27 nodes has the shape of the element of 20 nodes.
 *
 * Ids of mid nodes continue after the greatest id of the corners: edges in the order of the ids of
 * their ends, then faces in the order of their corners, then elements. So they are the same on any
 * number of ranks.
 *
 * Where interfaces are split, an edge with a copy for each side has a mid node for each side, at
 * the same place bitwise. In a periodic mesh, mid nodes have partners like corners, and copies are
 * whole periods apart bitwise.
 */
#pragma once

#include "Base/Runtime.h"
#include "Report/MeshFields.h"
#include "State/OutputState.h"

namespace vfm
{

/// Appends the mid nodes to the points of the mesh, with their geometry and nodal velocity, and
/// fills Mesh::MidPoints. Mesh::Pulls is empty afterwards.
/// @param order  Quadratic or Quadratic27
/// @param fields  ListDomain of a periodic mesh, else not used
/// @return field data of the whole mesh: CurvedMidNodes, the number of mid nodes off the middle of
///   their edge; StraightenedMidNodes, how many of them were moved back; CurvedJacobian, the
///   smallest Bezier coefficient of an element over that of the straight element, at most 1
/// @pre Collective over runtime.Group().
FieldArrays AddMidNodes(InterpolationOrder order, const FieldArrays& fields, Runtime& runtime,
  Mesh& mesh, OutputState& state);

} // namespace vfm
