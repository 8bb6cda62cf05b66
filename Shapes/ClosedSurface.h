/**
 * ClosedSurface: a surface of triangles as files store it, with repeated corners and triangles that
 * face either way, made into the boundary of a solid.
 */
#pragma once

#include "Shapes/ShapesTriangles.h"

#include <functional>

namespace vfm
{

/// The numbers of its points.
using PointTriangle = std::array<Index, 3>;

/// Its triangles face outwards, the walls of cavities into the cavities.
struct ClosedSurface
{
  std::vector<Vector3>
    Points; ///< those of the input; only the first of several at one place is used
  std::vector<PointTriangle> Triangles;
};

/// Merges points at the same place, drops triangles without area, turns the triangles of each
/// connected part to face the same way as its first one, and all of them if the volume is negative
/// then: the walls of a cavity must face against the outer wall. Throws InputError if a triangle
/// has the number of no point, a coordinate is not finite, or the surface is empty, open or not
/// manifold.
ClosedSurface CloseSurface(std::vector<Vector3> points, std::vector<PointTriangle> triangles);

/// The solid inside the surface. distance: signed, negative inside; evaluated only where other
/// shapes cut this one.
Shape MakeSolid(
  int material, const ClosedSurface& surface, std::function<double(const Vector3&)> distance);

} // namespace vfm
