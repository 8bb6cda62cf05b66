/**
 * HexCoefficients: the 27 Bernstein coefficients of the Jacobian of a trilinear hex, a polynomial
 * of degree two along each axis. If all are positive, the Jacobian is positive in the whole hex,
 * not only at its corners.
 */
#pragma once

#include "Base/Vector3.h"

namespace vfm
{

/// Returns the smallest coefficient of a hex, a lower bound of the Jacobian in it.
/// @param corners  numbered by bits
double SmallestCoefficient(const std::array<Vector3, 8>& corners);

} // namespace vfm
