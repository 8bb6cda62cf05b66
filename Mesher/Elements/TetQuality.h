/**
 * Quality of tetrahedra: Verdict's scaled Jacobian and dihedral angles.
 *
 * The parameter `points` holds the coordinates of all mesh points, (points, 3). The parameter `tet`
 * holds the corners a, b, c, d of one tet in VTK's order. Its volume has the sign of
 * det(b - a, c - a, d - a).
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <array>

namespace vfm
{

/// Corners of the face opposite to each corner of a positive tet,
/// counterclockwise seen from outside.
constexpr int FaceOfTet[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

/// Returns the power of two by which coordinates of an element are multiplied before its quality is
/// measured. Its lengths become about 1, so that products of up to eight lengths stay in the range
/// of double. The factor changes no bit of the result.
/// @param element  mesh points, (corners)
double LengthScale(const double* points, const Index* element, int corners);

/// Returns the scaled Jacobian of a tet, -1 to 1, with 1 for the regular tet: sqrt(2) 6 V over the
/// largest product, over the four corners, of the lengths of the three edges there. It is 0 if each
/// corner has an edge of length 0, where Verdict returns 1e30. Verdict's tet_scaled_jacobian;
/// Knupp, Int. J. Numer. Methods Engrg. 48 (2000) 1165-1185.
double TetScaledJacobian(const double* points, const Index* tet);

/// Computes the dihedral angles at the edges 01 02 03 12 13 23, in degrees, 0 to 180. They do not
/// depend on the sign of the volume. The angle is 0 at edges of a face without area.
void DihedralAngles(const double* points, const Index* tet, double angles[6]);

/// Statistics of dihedral angles.
struct AngleStatistics
{
  /// Number of angles per ten degrees. An angle less than 1e-6 degrees below a
  /// limit counts above it.
  std::array<std::int64_t, 18> Counts{};
  double Smallest = 180.0, Largest = 0.0;

  /// Adds the angles of other tets.
  void Add(const AngleStatistics& other);
};

/// Computes the scaled Jacobians of tets and returns the statistics of their dihedral angles.
/// @param tets  corners, (count, 4)
/// @param[out] scaledJacobians  one value per tet
AngleStatistics MeasureTets(
  const double* points, const Index* tets, Index count, float* scaledJacobians);

} // namespace vfm
