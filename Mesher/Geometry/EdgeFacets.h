/**
 * EdgeFacets: facets of smooth sides whose surface cannot be found from their points.
 */
#pragma once

#include "Elements/Facet.h"
#include "Elements/Mesh.h"

namespace vfm
{

using EdgeFacetRows = std::vector<std::array<std::int64_t, 5>>;

/// Returns the rows of GeometryTables::EdgeFacets of owned facets, with the ids that the points
/// have on their owners.
/// @param facets  facets of mesh.Surfaces
/// @param sides  side of each facet (DividedFacets)
/// @param mesh  the points must be classified
EdgeFacetRows ListEdgeFacets(
  const std::vector<Facet>& facets, const std::vector<int>& sides, const Mesh& mesh);

/// Returns the rows of the facets of the elements of this rank (Mesh::Facets), whichever rank owns
/// them, with the ids of the mesh.
EdgeFacetRows ListEdgeFacetsOfElements(const Mesh& mesh);

} // namespace vfm
