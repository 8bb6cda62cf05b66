/**
 * FlatMesh: meshes of a plane, which Modify/FlattenMesh makes from a layer of hexes. Their elements
 * are quads (4 corners) or triangles (3), counterclockwise, and their facets are edges: edge s
 * joins corner s and the next one.
 */
#pragma once

#include "Elements/Mesh.h"

namespace vfm
{

/// Elements of a plane.
enum class FlatElement
{
  Quad,
  Triangle ///< two from each quad, by the diagonal that leaves the larger smallest angle
};

/// Returns whether a mesh has elements of a plane. They have the ids of hexes.
inline bool IsFlat(const Mesh& mesh)
{
  return !mesh.HasHexes() && mesh.Ids.PointSlots == HexIds.PointSlots;
}

} // namespace vfm
