/**
 * ScaleFragments: gives free fragments another volume, by scaling them as a whole.
 *
 * A fragment is free if it touches no other fragment, as a drop in void that is not meshed. Its
 * elements keep their shape, so no barrier resists. Shifts of its surface, point by point, change
 * its volume slowly: the smaller the elements, the stiffer they are against the move of one point.
 */
#pragma once

#include "Interface/SurfaceTargets.h"
#include "Labels/FragmentShare.h"
#include "Smoothing/ElementEnergy.h"

namespace vfm
{

/// Scales free fragments about the mean of their points, or about the side of the domain on which
/// they lie. The targets of their points shift to where the points are then. A fragment stays as it
/// is if it lies on opposite sides or across a periodic side, if some of its points cannot move, if
/// a point would leave its bounds, or if elements of the barrier would become poor.
/// @param stage  of which the energy of elements counts
/// @param share  the fragments of this rank
/// @param factors  factor of lengths by fragment, equal on all its ranks; 1: the fragment stays
/// @return the points of this rank that have moved
/// @pre Collective.
std::vector<int> ScaleFragments(const SurfaceTargets& targets, const ElementEnergy& energy,
  const SmoothingStage& stage, const FragmentShare& share, std::vector<double> factors,
  Runtime& runtime, ActiveMesh& mesh);

} // namespace vfm
