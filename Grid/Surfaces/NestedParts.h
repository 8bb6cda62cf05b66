/**
 * NestedParts: finds the components of a surface that are inside of others.
 */
#pragma once

#include "Surfaces/OrientTriangles.h"

namespace vfm
{

/// Returns, for each component, whether it is inside of an odd number of others, so that it is the
/// wall of a cavity. Components must not cross; they may touch.
/// @param distance  a component does not count as inside or outside of another at places where
///   both are closer to each other
std::vector<bool> FindCavities(
  const PatchTriangles& surface, const SurfaceParts& parts, double distance);

} // namespace vfm
