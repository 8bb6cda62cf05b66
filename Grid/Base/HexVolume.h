/**
 * The volume of a trilinear hex.
 */
#pragma once

#include "Base/Vector3.h"

namespace vfm
{

/// Returns the volume of the trilinear hex between the quads a and b, whose corners are in VTK's
/// order. The Gauss rule with 2x2x2 points is exact.
double VolumeBetween(const std::array<Vector3, 4>& a, const std::array<Vector3, 4>& b);

} // namespace vfm
