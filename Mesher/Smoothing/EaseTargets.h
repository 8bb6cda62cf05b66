/**
 * EaseTargets: lets quality prevail over given surfaces where both are not possible.
 */
#pragma once

#include "Smoothing/Smoother.h"

namespace vfm
{

/// Lowers the weights of the targets that attract the points of poor elements, and moves the points
/// again. Repeats this until no such element is left or all weights are a tenth of those of
/// quadrics. Poor are hexes with a scaled Jacobian below 0.5, at edges that fade out 0.61 (the noise
/// of scanned surfaces has many), and tets with angles below 20 or above 150 degrees.
/// @param stage  last stage of the ramp
/// @return whether points moved
/// @pre Collective.
bool EaseTargets(const SmoothingStage& stage, Smoother& smoother);

} // namespace vfm
