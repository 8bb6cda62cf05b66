/**
 * CoarseSmoothing: the last smoothing of a refined grid. All points of transition hexes and their
 * neighbours move, including points shared with cells, whose hexes are then not exact boxes. Points
 * that the interfaces have moved are fixed.
 *
 * The points of all levels move in each sweep, because where two levels meet, points of one level
 * cannot move far enough. Colours are defined in TransitionSmoothing.h, level after level, because
 * a hex at such a place has points that stem from nodes of both levels. Finally, only the points of
 * hexes that are still poor move.
 */
#pragma once

#include "Elements/Hex/CoarseHexes.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Smooths the transitions of a mesh. Hexes that are positive stay positive.
/// @param isFrozen  whether each point of the mesh is fixed
/// @pre Collective.
void SmoothCoarse(const CoarseHexes& coarse, const std::vector<unsigned char>& isFrozen, Mesh& mesh,
  Runtime& runtime);

} // namespace vfm
