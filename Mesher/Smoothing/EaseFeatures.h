/**
 * EaseFeatures: lets quality prevail over edges where both are not possible.
 */
#pragma once

#include "Smoothing/Smoother.h"

namespace vfm
{

/// Lowers the weights of the edges that attract the points of poor elements, hexes with a scaled
/// Jacobian below 0.46 or tets with an angle below 20 or above 150 degrees, and moves the points
/// again. Repeats this until no such element is left or all weights are those of quadrics.
/// @param stage  last stage of the ramp
/// @return whether points moved
/// @pre Collective.
bool EaseFeatures(const SmoothingStage& stage, Smoother& smoother);

} // namespace vfm
