/**
 * OuterSmoothing: the last smoothing of a refined grid. All points of transition hexes and those beside them move, also the
 * ones that they share with cells, whose hexes are then no exact boxes any more. Points that the interfaces moved stay.
 *
 * Level by level, since the points that stem from the nodes of one level move by colour as in TransitionSmoothing.h.
 */
#pragma once

#include "ActiveMesh.h"
#include "OuterHexes.h"

namespace vfm
{

/// isFrozen: of the points of the mesh, those that stay. Only improves: hexes that are positive stay so. Collective.
void SmoothOuter(const OuterHexes& outer, const std::vector<unsigned char>& isFrozen, Mesh& mesh,
  Runtime& runtime);

} // namespace vfm
