/**
 * Films, shells, threads and drops, thinner than a cell, in unit cells.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "Shapes/Shapes.h"

namespace vfm
{
namespace testing
{

/// Makes a film around a plane.
Shape MakeFilm(const Vector3& point, const Vector3& normal, double thickness);
Shape MakeShell(const Vector3& center, double radius, double thickness);
/// Makes an endless thread.
Shape MakeThread(const Vector3& point, const Vector3& direction, double diameter);

/// Returns 27 drops of a volume in cells, in 18^3 cells, at random distances from the middles of
/// cells.
std::vector<Shape> MakeDrops(double volume, unsigned seed);

/// Returns directions of films that lie at all angles to the grid, unit vectors of one octant.
std::vector<Vector3> ListDirections(int count);

} // namespace testing
} // namespace vfm
