/**
 * LayerFacets: facets, surfaces and curves of a mesh whose columns are cut into layers.
 */
#pragma once

#include "Modify/LayerParts.h"

namespace vfm
{

/// The geometry in which new points of an edge lie.
struct EdgeGeometry
{
  int Dimension, Id; ///< GeometryDimension and GeometryId
};

/// Returns the geometry of the inside of each edge.
/// @param mesh before it is cut
/// @pre Collective
std::vector<EdgeGeometry> FindEdgeGeometry(
  const Mesh& mesh, const LayerColumns& columns, Ranks& ranks);

/// Cuts Mesh::Facets, Surfaces, Curves and the list of facets in Tables.
/// @param mesh with the points of the parts
/// @pre Collective
void CutFacets(const LayerParts& parts, Ranks& ranks, Mesh& mesh);

} // namespace vfm
