/**
 * NodeCopies: the copies of nodes that a mesh needs where faces between its elements are cut.
 *
 * The elements around a node form groups: two elements with a common face at the node are in one
 * group, unless the face is cut. Each group gets its own copy of the node. Ranks are the same as
 * one: elements of other ranks count, and ids follow from global ids only.
 *
 * In a periodic mesh, elements on opposite sides count as neighbours, unless the face between them
 * is cut. A copy on one side then has a partner on the other side if their groups are connected.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// A corner of an element at a node that has several copies, or is on a cut face.
struct CornerCopy
{
  Index Corner;  ///< index in MeshData::Elements
  Index Id;      ///< global id of the copy of the node
  Index Partner; ///< PeriodicPartner of the copy; its own id if the mesh is not periodic
};

/// Finds the copies of the nodes of cut faces.
/// The group with the lowest global element id keeps the id of its node. Further copies get the ids
/// after the greatest one of the mesh, in the order of node id and lowest element id.
/// @param mesh part of this rank, with Facets, PointIds, ElementIds, GeometryDimension
/// @param isCut of each facet; the same for both elements of a face, on any rank
/// @return all corners of this rank at nodes of cut faces, by point and place
/// @pre Collective
std::vector<CornerCopy> FindNodeCopies(
  const MeshData& mesh, const std::vector<char>& isCut, Ranks& ranks);

} // namespace vfm
