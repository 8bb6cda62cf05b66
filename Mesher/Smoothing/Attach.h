/**
 * Attaches the points of an active mesh to the targets of its interfaces, and lists the facets by
 * which volumes are measured.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Facet.h"
#include "Smoothing/ActiveMesh.h"

#include <functional>

namespace vfm
{

/// Returns the target (SurfaceTargets) of a pair of labels, the smaller first, at a point of an
/// active mesh; -1 if the point has no target for this pair.
using FindTarget = std::function<Index(int point, const std::array<int, 2>& labels)>;

/// Attaches the active points to the target of each pair of labels whose interface has a
/// facet there.
/// @param findTarget  is called by several threads at once
void AttachToFacets(const std::vector<Facet>& facets, const FindTarget& findTarget,
  Runtime& runtime, ActiveMesh& active);

/// Fills ActiveMesh::Facets with the owned facets of interfaces.
void SetFacets(const std::vector<Facet>& facets, Runtime& runtime, ActiveMesh& active);

} // namespace vfm
