/**
 * Quality of tetrahedra: verdict's scaled Jacobian, and dihedral angles. points: xyz of all points of the mesh; tet: the four
 * corners of one tet in VTK's order, the volume positive where det(b - a, c - a, d - a) is.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <array>

namespace vfm
{

/// Corners of the face opposite to each corner of a positive tet, counterclockwise as seen from outside.
constexpr int FaceOfTet[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

/// sqrt(2) 6 V over the largest product, over the four corners, of the lengths of the three edges there: -1..1, 1 in the regular tet
/// (Knupp 2000; verdict's tet_scaled_jacobian). 0 where no corner has three edges of some length (there verdict gives 1e30).
double TetScaledJacobian(const double* points, const Index* tet);

/// Degrees, 0..180, at the edges 01 02 03 12 13 23; those of a mirrored tet are the same. 0 at edges where a face has no area.
void DihedralAngles(const double* points, const Index* tet, double angles[6]);

/// The dihedral angles of some tets.
struct AngleStatistics
{
  std::array<std::int64_t, 18>
    Counts{}; ///< in each ten degrees; those at a limit or less than 1e-6 degrees below count above it
  double Smallest = 180.0, Largest = 0.0;

  /// That of others too.
  void Add(const AngleStatistics& other);
};

/// Fills the scaled Jacobians of tets, given by four points each.
AngleStatistics MeasureTets(
  const double* points, const Index* tets, Index count, float* scaledJacobians);

} // namespace vfm
