/**
 * MaterialsBehind: the materials on the other side of facets.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Returns the material behind each facet, also across a periodic side, or NothingBehind.
/// @param mesh with Facets
/// @pre Collective
std::vector<Index> FindMaterialsBehind(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
