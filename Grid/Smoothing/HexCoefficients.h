/**
 * HexCoefficients: the 27 Bernstein coefficients of the Jacobian of a trilinear hex, a polynomial
 * of degree two along each axis. If all are positive, the Jacobian is positive in the whole hex,
 * not only at its corners.
 */
#pragma once

#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Returns the smallest coefficient of a hex, a lower bound of the Jacobian in it.
/// @param corners  numbered by bits
double SmallestCoefficient(const std::array<Vector3, 8>& corners);

/// Returns whether all coefficients of all hexes on this rank exceed 1e-6 cell volumes.
bool HavePositiveCoefficients(const ActiveMesh& mesh, Runtime& runtime);

/// Returns whether the coefficients of each hex at a point, moved to x, exceed 1e-6 cell volumes or
/// are not smaller than the smallest one at its current position.
bool KeepPositiveCoefficients(const ActiveMesh& mesh, int point, const Vector3& x);

} // namespace vfm
