/**
 * FacetSides: which sides of its elements the facets of a mesh are.
 */
#pragma once

#include "Mesh/ElementFaces.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// A facet as one of its elements has it.
struct FacetSide
{
  FaceIds Points;  ///< of the mesh
  MeshFacet Facet; ///< its Behind is not the material of the element
};

/// The facets in Surfaces, each once for every meshed fragment at it; without their elements. Facets with a point below 0 are left out.
std::vector<FacetSide> ListFacetSides(const Mesh& mesh);

/// The facets of the mesh (Mesh::Facets) with their points.
std::vector<FacetSide> ListPointsOfFacets(const Mesh& mesh);

/// The facets of the elements of the mesh that have such a side, ascending by element and side.
/// mesh: its GeometryDimension is below 3 at all points of the sides.
std::vector<MeshFacet> FindElements(std::vector<FacetSide> sides, const Mesh& mesh);

} // namespace vfm
