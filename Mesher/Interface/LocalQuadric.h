/**
 * LocalQuadric: a quadric surface over a plane, in the local frame of a node (Interface.h: lengths
 * are in cells, the node is at 0).
 *
 *   w = c0 + c1 u + c2 v + c3 u^2 + c4 u v + c5 v^2
 */
#pragma once

#include "Base/Vector3.h"

#include <array>

namespace vfm
{

/// Quadric with its base plane.
struct LocalQuadric
{
  Vector3 Base;              ///< point where u = v = w = 0
  Vector3 U, V, N;           ///< unit vectors; N points to the second label
  std::array<double, 6> C{}; ///< c0 to c5
};

/// Returns the plane through a point with a unit normal.
inline LocalQuadric MakeLocalPlane(const Vector3& point, const Vector3& normal)
{
  LocalQuadric plane{ point, {}, {}, normal, {} };
  MakeTangents(plane.N, plane.U, plane.V);
  return plane;
}

/// Height and slopes of a quadric over the projection of a point y onto its base plane.
struct QuadricHeight
{
  double U, V;           ///< coordinates of y
  double W;              ///< height of the surface there
  double AlongU, AlongV; ///< slopes of the surface there
};

/// Returns height and slopes of a surface over y.
inline QuadricHeight HeightAt(const LocalQuadric& s, const Vector3& y)
{
  const Vector3 r = y - s.Base;
  const double u = Dot(r, s.U), v = Dot(r, s.V);
  const std::array<double, 6>& c = s.C;
  return { u, v, c[0] + c[1] * u + c[2] * v + c[3] * u * u + c[4] * u * v + c[5] * v * v,
    c[1] + 2.0 * c[3] * u + c[4] * v, c[2] + c[4] * u + 2.0 * c[5] * v };
}

/// Returns the distance of y to the tangent plane over y, positive on the side of the second label.
/// @param[out] gradient  unit normal of that plane
inline double DistanceTo(const LocalQuadric& s, const Vector3& y, Vector3& gradient)
{
  const QuadricHeight h = HeightAt(s, y);
  const double steep = 1.0 / std::sqrt(1.0 + h.AlongU * h.AlongU + h.AlongV * h.AlongV);
  gradient = steep * (s.N - h.AlongU * s.U - h.AlongV * s.V);
  return steep * (Dot(y - s.Base, s.N) - h.W);
}

/// Returns the point of a surface near y after a number of Newton steps.
/// @param[out] normal  unit normal where the last step began
inline Vector3 FootOn(const LocalQuadric& s, Vector3 y, int steps, Vector3& normal)
{
  for (int step = 0; step < steps; ++step)
  {
    const double distance = DistanceTo(s, y, normal);
    y = y - distance * normal;
  }
  return y;
}

/// Returns the same surface with its base on it, over or under y.
inline LocalQuadric Recentred(const LocalQuadric& s, const Vector3& y)
{
  const QuadricHeight h = HeightAt(s, y);
  LocalQuadric result = s;
  result.Base = s.Base + h.U * s.U + h.V * s.V + h.W * s.N;
  result.C = { { 0.0, h.AlongU, h.AlongV, s.C[3], s.C[4], s.C[5] } };
  return result;
}

/// Returns the same surface in the frame of another node, where the node of its own
/// frame is at `from`.
inline LocalQuadric Moved(LocalQuadric s, const Vector3& from)
{
  s.Base = s.Base + from;
  return s;
}

} // namespace vfm
