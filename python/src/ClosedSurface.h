/**
 * ClosedSurface: the solid in a surface of triangles as files hold them: corners repeated, facing any way.
 */
#pragma once

#include "Shapes/Shapes.h"

namespace vfm
{

/// A triangle by the numbers of its points.
using PointTriangle = std::array<Index, 3>;

/// Points at one place become one, triangles without area are dropped, those of a part of the surface turned to face one way, and all of them if the
/// whole volume is negative then: walls of cavities must face against the walls around. Throws InputError on numbers that are none of points, places that are
/// not finite, and surfaces that are open or not manifold. The shape knows its volume in boxes, no distance: no other shape may cut it.
Shape MakeSolid(
  int material, const std::vector<Vector3>& points, std::vector<PointTriangle> triangles);

} // namespace vfm
