/**
 * MeshFacets: the faces of a mesh at which its materials change or it ends, across the ranks.
 */
#pragma once

#include "Mesh/FacetSides.h"
#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

namespace vfm
{

/// Collective: the faces of this rank's elements behind which there is another value, or nothing, by element and side; points around each. values: of the
/// elements, >= 0. mesh: with PointIds; its GeometryDimension, when it is there, excludes faces with a point inside (3).
/// Throws InputError, on all ranks alike, when an array is missing or a face belongs to more than two elements.
std::vector<FacetSide> FindMeshFaces(const MeshData& mesh, const int* values, Ranks& ranks);

/// Collective: the facets of this rank's elements by element and side: mesh.Facets, or found by a search. A facet between elements of two
/// ranks is in the lists of both. Without the field DomainBounds nothing is on the domain; without SurfaceParts and EdgeFacets all
/// Surface are 0. Throws as FindMeshFaces.
std::vector<MeshFacet> FindMeshFacets(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
