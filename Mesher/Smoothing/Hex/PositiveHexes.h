/**
 * PositiveHexes: the condition that moving points keep: all coefficients of the Jacobian of a hex
 * (HexCoefficients.h) are positive.
 */
#pragma once

#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Marks the points of the hexes on this rank that have a coefficient of at most 1e-6 cell volumes,
/// or .01 where only some active points went back. Between positions of different stages, such a
/// hex may be so poor that no further move within these conditions makes it good again.
/// @param returned  whether each point went back; empty: none
/// @param where  hexes without a flagged active point may be left out; empty: none
/// @param[in,out] points  flags of all points
/// @return whether there is such a hex
bool MarkSmallCoefficients(const ActiveMesh& mesh, Runtime& runtime,
  const std::vector<unsigned char>& returned, const std::vector<unsigned char>& where,
  std::vector<unsigned char>& points);

/// Returns whether the coefficients of each hex at a point, moved to x, exceed 1e-6 cell volumes or
/// are not smaller than the smallest one at its current position.
bool KeepPositiveCoefficients(const ActiveMesh& mesh, int point, const Vector3& x);

} // namespace vfm
