/**
 * Which points of a mesh carry edges and corners of interfaces (CreaseRules), and what they are drawn to.
 */
#pragma once

#include "Creases/Creases.h"
#include "Mesh/CreaseKind.h"
#include "Mesh/Facet.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// The models of an interface, and its first surface point among the targets.
struct InterfaceCreases
{
  const Creases& Models;
  const Interface& Source;
  Index FirstTarget;
};

/// Draws points near edges to the surfaces of the models of the surface points that they are attached to, in place of their quadrics: carriers to those that
/// meet there. Appends these surfaces to the targets. Returns the kind of every point of the active mesh, the same on all ranks that hold it. Collective.
std::vector<CreaseKind> AttachCreases(const InterfaceCreases& creases,
  const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets, ActiveMesh& active,
  Runtime& runtime);

} // namespace vfm
