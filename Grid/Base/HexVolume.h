/**
 * The volume of a trilinear hex.
 */
#pragma once

#include "Base/Vector3.h"

namespace vfm
{

/// Of the trilinear hex from the quad a to the quad b, by Gauss's rule of 2x2x2 points (exact). Corners in VTK's order.
double VolumeBetween(const std::array<Vector3, 4>& a, const std::array<Vector3, 4>& b);

} // namespace vfm
