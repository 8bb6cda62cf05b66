/**
 * Planes in cells (PLIC, piecewise linear interface calculation) in the frame of the unit cell centred
 * at the origin.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// Volume of the unit cell centred at 0 where n.x < d. n need not be a unit vector; not zero.
/// Scardovelli, Zaleski (2000): analytic relations connecting linear interfaces and volume fractions.
double VolumeBelowPlane(const Vector3& n, double d);

/// The d for which VolumeBelowPlane(n, d) = fraction, by bisection to 1e-12 of the cell.
double PlaneOfVolume(const Vector3& n, double fraction);

} // namespace vfm
