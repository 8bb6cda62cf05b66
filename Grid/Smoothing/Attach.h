/**
 * Ties an active mesh to its interfaces: which targets its surface points are drawn to, and the facets that volumes are
 * measured with.
 */
#pragma once

#include "Base/Partition.h"
#include "Labels/Fragments.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Where the surface points are the mixed nodes, points[n] the point of the n-th node of the interface or -1: each is drawn to
/// the targets of its node, and every interface face is a facet (a quad).
void AttachToNodes(const Interface& interface, const std::vector<int>& points,
  const Fragments& fragments, const Partition& partition, ActiveMesh& active);

} // namespace vfm
