/**
 * AttachFeatures: attaches points of an active mesh to sharp edges and corners of interfaces.
 */
#pragma once

#include "Elements/MeshRun.h"
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

/// Finds the edges of interfaces, if the options request it, and attracts the attached points to
/// them: from the given surfaces on all levels, from the fractions on the finest. Refines the
/// targets of curved elements.
/// @param interfaces  LevelInterfaces::All
/// @param facets  facets whose edges may be sharp
/// @param[in,out] targets,active  targets and attached points; points near edges get new targets
/// @return kind of every point of the active mesh
/// @pre Collective.
std::vector<FeatureKind> AttachToFeatures(const MeshCells& cells,
  const std::vector<const Interface*>& interfaces, const std::vector<Facet>& facets,
  const Mesh& mesh, MeshRun& run, SurfaceTargets& targets, ActiveMesh& active);

} // namespace vfm
