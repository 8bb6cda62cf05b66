/**
 * Ties an active tetrahedral mesh to its interfaces.
 */
#pragma once

#include "Base/Options.h"
#include "Mesh/Facet.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Draws every interface point to the target of each pair of labels that meets there: the one of the mixed node within two
/// nodes whose surface point is nearest; in Cells that of its own node. Pairs without one stay free.
void AttachTets(const Interface& interface, const Mesh& mesh, const std::vector<Facet>& facets,
  TetMethod method, Runtime& runtime, ActiveMesh& active);

} // namespace vfm
