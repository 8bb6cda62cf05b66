/**
 * Quality of elements with the definitions of the Verdict library.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Elements/MeshReport.h"

namespace vfm
{

/// Returns the scaled Jacobian of a hex, -1 to 1: the minimum, over its 8 corners and its centre,
/// of the determinant of three edge vectors over the product of their lengths. Verdict's
/// hex_scaled_jacobian; Knupp, Int. J. Numer. Methods Engrg. 48 (2000) 1165-1185.
/// @param points  coordinates of all mesh points, (points, 3)
/// @param hex  the eight corners in VTK's order
double HexScaledJacobian(const double* points, const Index* hex);
/// Returns Verdict's scaled Jacobian of a quad or triangle of a plane: of a quad the smallest sine
/// of its angles, of a triangle 2 / sqrt(3) times the sine at its longest two edges, 1 if
/// equilateral.
/// @param element  mesh points, (corners); counterclockwise from one of both sides
double FlatScaledJacobian(const double* points, const Index* element, int corners);

/// Returns whether HexScaledJacobian of every cell rounds to 1 in single precision. The relative
/// rounding errors of coordinate differences, and therefore the errors of angles, are below 2^-16.
bool AreCellsPerfect(const CartesianGrid& grid);

/// Fills mesh.ScaledJacobian and the minimum and mean over all ranks in the report. Also fills the
/// dihedral angles of the report if the mesh consists of tets.
/// @param wholeCells  number of hexes, from the first one, that are unchanged cells
/// @param leftOut  number of hexes in CellRuns
/// @pre Collective.
void ComputeQuality(
  Mesh& mesh, Runtime& runtime, MeshReport& report, Index wholeCells = 0, Index leftOut = 0);

} // namespace vfm
