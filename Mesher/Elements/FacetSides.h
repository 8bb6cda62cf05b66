/**
 * FacetSides: the sides of elements that are facets of the mesh.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/ElementFaces.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Side of an element that is a facet.
struct FacetSide
{
  FaceIds Points;  ///< points of the mesh
  MeshFacet Facet; ///< Facet.Behind differs from the material of the element
};

/// Returns the facets in mesh.Surfaces, once for each meshed fragment at a facet, without their
/// elements. Facets with a negative point are omitted.
std::vector<FacetSide> ListFacetSides(const Mesh& mesh, Runtime& runtime);

/// Returns the facets in Mesh::Facets with their points.
std::vector<FacetSide> ListPointsOfFacets(const Mesh& mesh);

/// Finds the elements of facets.
/// @param sides  facets without elements
/// @param mesh  GeometryDimension must be below 3 at all points of the facets
/// @return facets of elements, ascending by element and side
std::vector<MeshFacet> FindElements(
  std::vector<FacetSide> sides, const Mesh& mesh, Runtime& runtime);

} // namespace vfm
