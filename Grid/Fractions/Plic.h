/**
 * Planes in cells (PLIC, piecewise linear interface calculation), in coordinates of the unit cell
 * centred at the origin.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// Returns the volume of the unit cell centred at the origin where n.x < d. Scardovelli and
/// Zaleski, Analytical relations connecting linear interfaces and volume fractions in rectangular
/// grids, J. Comput. Phys. 164 (2000) 228-237.
/// @param n  normal of any length, not zero
double VolumeBelowPlane(const Vector3& n, double d);

/// Returns the d for which VolumeBelowPlane(n, d) = fraction, by bisection to 1e-12 of the cell.
double PlaneOfVolume(const Vector3& n, double fraction);

} // namespace vfm
