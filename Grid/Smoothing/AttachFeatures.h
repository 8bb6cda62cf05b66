/**
 * The points of an active mesh drawn to edges and corners of interfaces.
 */
#pragma once

#include "Mesh/Mesh.h"
#include "SharpFeatures/Attach.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Replaces the attachments of points near edges by the surfaces that PullToFeatures finds, and asks less of hexes at acute edges.
/// Returns the kind of every point of the active mesh, the same on all ranks that hold it. Collective.
std::vector<FeatureKind> AttachFeatures(const InterfaceFeatures& features,
  const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets, ActiveMesh& active,
  Runtime& runtime);

} // namespace vfm
