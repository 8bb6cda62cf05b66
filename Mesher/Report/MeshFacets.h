/**
 * MeshFacets: finds the faces between different materials and on the boundary of a mesh.
 */
#pragma once

#include "Elements/MeshFacet.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Finds the faces of this rank's elements where values change or the mesh ends.
/// @param mesh mesh with PointIds; faces with a point of GeometryDimension 3 are excluded if known
/// @param values value >= 0 of each element
/// @return faces ordered by element and side, without their surfaces and sides of the domain
/// @throws InputError if an array is missing, or if MatchFaces does; on all ranks
/// @pre Collective
std::vector<MeshFacet> FindMeshFaces(const MeshData& mesh, const int* values, Ranks& ranks);

/// Returns the facets of this rank's elements: mesh.Facets, or the result of a search.
/// The search needs the field DomainBounds to find sides of the domain, and SurfaceParts and
/// EdgeFacets to find smooth sides, of this rank if there are SurfaceIds (ListSides); otherwise
/// DomainSide is NoSide, and Surface is 0.
/// @return facets ordered by element and side; facets between two ranks are in the lists of both
/// @throws InputError if FindMeshFaces does
/// @pre Collective
std::vector<MeshFacet> FindMeshFacets(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
