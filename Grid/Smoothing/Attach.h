/**
 * Ties an active mesh to its interfaces: which targets its points are drawn to, and the facets that volumes are measured with.
 */
#pragma once

#include "Base/Runtime.h"
#include "Mesh/Facet.h"
#include "Smoothing/ActiveMesh.h"

#include <functional>

namespace vfm
{

/// The target (SurfaceTargets) of a pair of labels, the smaller first, at a point of an active mesh; -1: none, the point stays free of
/// that pair.
using FindTarget = std::function<Index(int point, const std::array<int, 2>& labels)>;

/// Draws the points that move to the target of each pair of labels whose interface has a facet there. findTarget: may be called by several
/// threads at once.
void AttachToFacets(const std::vector<Facet>& facets, const FindTarget& findTarget,
  Runtime& runtime, ActiveMesh& active);

/// Fills ActiveMesh::Facets with the owned facets of interfaces.
void SetFacets(const std::vector<Facet>& facets, ActiveMesh& active);

} // namespace vfm
