/**
 * CoarseSmoothing: the last smoothing of a refined grid. All points of transition hexes and those beside them move, also the
 * ones that they share with cells, whose hexes are then no exact boxes any more. Points that the interfaces moved stay.
 *
 * The points of all levels take part in each sweep, for where two levels meet neither has room alone. Colours are those of
 * TransitionSmoothing.h, level after level: a hex there has points that stem from nodes of both. At last only the
 * points of hexes that are still poor move.
 */
#pragma once

#include "Hex/CoarseHexes.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// isFrozen: of the points of the mesh, those that stay. Only improves: hexes that are positive stay so. Collective.
void SmoothCoarse(const CoarseHexes& coarse, const std::vector<unsigned char>& isFrozen, Mesh& mesh,
  Runtime& runtime);

} // namespace vfm
