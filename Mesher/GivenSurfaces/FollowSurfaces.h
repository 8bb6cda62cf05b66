/**
 * FollowSurfaces: targets, edges and corners of interfaces from the given surfaces of bodies,
 * instead of from the fractions.
 */
#pragma once

#include "GivenSurfaces/BodySurfaces.h"
#include "SharpFeatures/SharpFeatures.h"

namespace vfm
{

/// Interface of one grid, and the targets of its surface points.
struct LevelSurface
{
  const Interface& Source;
  const FractionField& Fractions; ///< of the same grid
  Index FirstTarget;              ///< target of the first surface point
  double Ratio;                   ///< factor from its grid coordinates to those of the finest grid
};

/// Replaces the targets of points that have a surface by quadrics fitted to it, and finds the
/// models of its edges and corners. Points of pairs of labels without a surface, and points
/// farther than 1.8 cells from a part of the surface that faces like the interface, keep their
/// targets.
/// @param bodies  surfaces of the labels
/// @param hasEdges  false: no models
/// @param[in,out] targets  of kind Quadrics
/// @return models at the surface points of owned nodes and of nodes within two of them
SharpFeatures FollowSurfaces(const BodySurfaces& bodies, const LevelSurface& level, bool hasEdges,
  const Partition& partition, Runtime& runtime, SurfaceTargets& targets);

} // namespace vfm
