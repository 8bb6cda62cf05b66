/**
 * Which points of a mesh carry edges and corners of interfaces, and what they are drawn to.
 */
#pragma once

#include "Creases/Creases.h"
#include "Mesh/CreaseKind.h"
#include "Mesh/Facet.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// The surface point that an attachment of a point of an active mesh was made from: position in Interface::Points() of the finest level, or -1.
using SurfacePointOf = std::function<Index(const Attachment&)>;

/// Draws points near edges to the surfaces of the models there in place of the quadrics that they are attached to; appends these surfaces to the
/// targets. Returns the kind of every point of the active mesh, the same on all ranks that hold it. Collective.
std::vector<CreaseKind> AttachCreases(const Creases& creases, const SurfacePointOf& surfacePoint,
  const std::vector<Facet>& facets, SurfaceTargets& targets, ActiveMesh& active);

} // namespace vfm
