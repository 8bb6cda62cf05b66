/**
 * SeamFacets: the faces of a periodic mesh on the sides where the domain repeats.
 */
#pragma once

#include "Mesh/Mesh.h"

namespace vfm
{

/// Adds these faces to Mesh::Facets, as facets on sides of the domain.
/// @param domain grid of the domain (LeaveCovering.h)
/// @param isPeriodic whether the domain repeats along each axis
/// @pre Collective
void AddSeamFacets(
  const CartesianGrid& domain, const std::array<bool, 3>& isPeriodic, Ranks& ranks, Mesh& mesh);

} // namespace vfm
