/**
 * AttachFeatures: attaches points of an active mesh to sharp edges and corners of interfaces.
 */
#pragma once

#include "Elements/Mesh.h"
#include "SharpFeatures/Attach.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Replaces the attachments of points near sharp features by the surfaces that PullToFeatures
/// finds. Lowers the target quality of hexes at acute edges.
/// @param facets  surface facets of this rank
/// @param[in,out] targets  the surfaces are appended
/// @return kind of each point of the active mesh, equal on all ranks that hold it
/// @pre Collective.
std::vector<FeatureKind> AttachFeatures(const InterfaceFeatures& features,
  const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets, ActiveMesh& active,
  Runtime& runtime);

} // namespace vfm
