/**
 * Closed surfaces of triangles for tests.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "Surfaces/InputSurfaces.h"

namespace vfm
{
namespace testing
{

/// Returns the surface of a box.
/// @param parts  number of squares along each edge, which are two triangles each
ClosedSurface BoxSurface(const Vector3& lower, const Vector3& upper, int parts = 1);

/// Returns a sphere of triangles.
/// @param rings  number of rings of triangles from pole to pole
ClosedSurface SphereSurface(const Vector3& centre, double radius, int rings);

/// Returns a surface that faces the other way: the wall of a cavity.
ClosedSurface Reversed(ClosedSurface surface);

/// Returns the triangles of two surfaces.
ClosedSurface Together(ClosedSurface first, const ClosedSurface& second);

/// Returns a tube along x with closed ends that are rings.
/// @param segments  number of flat sides around
ClosedSurface TubeSurface(
  const Vector3& start, double length, double outerRadius, double innerRadius, int segments);

/// Returns a surface that is turned about a point by Euler angles in degrees about x, y, z (R =
/// Rz Ry Rx).
ClosedSurface Turned(ClosedSurface surface, const Vector3& centre, const Vector3& degrees);

/// Returns bodies of the names "1", "2", ..
InputSurfaces MakeBodies(const std::vector<ClosedSurface>& surfaces);

/// Returns the exact fractions of bodies, of materials 1, 2, ..., in the local cells of a grid.
FractionField FractionsOfBodies(const CartesianGrid& grid, const InputSurfaces& surfaces);

} // namespace testing
} // namespace vfm
