/**
 * FollowSurfaces: targets, edges and corners of interfaces from the given surfaces of bodies,
 * instead of from the fractions.
 */
#pragma once

#include "GivenSurfaces/BodySurfaces.h"
#include "SharpFeatures/SharpFeatures.h"

namespace vfm
{

/// Replaces the targets of points that have a surface by quadrics fitted to it, and finds the
/// models of its edges and corners. Points of pairs of labels without a surface, and points
/// farther than 1.8 cells from a part of the surface that faces like the interface, keep their
/// targets.
/// @param interfaces  of all levels, the finest last, as of LevelInterfaces::All
/// @param hasEdges  false: no models
/// @param[in,out] targets  of the interfaces, of kind Quadrics
/// @return models of the surface points of owned nodes and of nodes within two of them
SharpFeatures FollowSurfaces(const BodySurfaces& bodies,
  const std::vector<const Interface*>& interfaces, bool hasEdges, Runtime& runtime,
  SurfaceTargets& targets);

} // namespace vfm
