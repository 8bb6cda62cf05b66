/**
 * SidePoints: the points on the sides of the domain.
 */
#pragma once

#include "Elements/MeshFacet.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Returns the points of this rank on each side of the domain, -x +x -y +y -z +z, ascending. On
/// opposite sides of a periodic mesh, points with a copy on the other side come first, in the order
/// of their partners; if one rank has the mesh, both sides have the same order.
/// @param facets FindMeshFacets of the mesh
std::array<std::vector<Index>, 6> FindSidePoints(
  const MeshData& mesh, const std::vector<MeshFacet>& facets);

} // namespace vfm
