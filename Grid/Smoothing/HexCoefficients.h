/**
 * The 27 Bernstein coefficients of the Jacobian of a trilinear hex, a polynomial of degree two along each axis: where all are
 * positive the hex is positive throughout, not at its corners alone.
 */
#pragma once

#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// The smallest coefficient of a hex, its corners by bits: nowhere in the hex is the Jacobian smaller.
double SmallestCoefficient(const std::array<Vector3, 8>& corners);

/// Whether all coefficients of all hexes are larger than 1e-6 cell volumes.
bool HavePositiveCoefficients(const ActiveMesh& mesh, Runtime& runtime);

/// Whether the hexes at a point have such coefficients, or none smaller than now, when the point stands at x.
bool KeepPositiveCoefficients(const ActiveMesh& mesh, int point, const Vector3& x);

} // namespace vfm
