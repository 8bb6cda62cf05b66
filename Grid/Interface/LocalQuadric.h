/**
 * LocalQuadric: a surface over a plane, in the local frame of a node (Interface.h: lengths in cells, the node at 0).
 *
 *   w = c0 + c1 u + c2 v + c3 u^2 + c4 u v + c5 v^2
 */
#pragma once

#include "Base/Vector3.h"

#include <array>

namespace vfm
{

struct LocalQuadric
{
  Vector3 Base;    ///< where u = v = w = 0
  Vector3 U, V, N; ///< unit vectors; N points to the second label
  std::array<double, 6> C{};
};

inline LocalQuadric MakeLocalPlane(const Vector3& point, const Vector3& normal)
{
  LocalQuadric plane{ point, {}, {}, normal, {} };
  MakeTangents(plane.N, plane.U, plane.V);
  return plane;
}

/// The tangent plane over the foot of y along N: value and slopes along U and V.
struct QuadricHeight
{
  double U, V;           ///< of y
  double W;              ///< of the surface there
  double AlongU, AlongV; ///< its slopes
};

inline QuadricHeight HeightAt(const LocalQuadric& s, const Vector3& y)
{
  const Vector3 r = y - s.Base;
  const double u = Dot(r, s.U), v = Dot(r, s.V);
  const std::array<double, 6>& c = s.C;
  return { u, v, c[0] + c[1] * u + c[2] * v + c[3] * u * u + c[4] * u * v + c[5] * v * v,
    c[1] + 2.0 * c[3] * u + c[4] * v, c[2] + c[4] * u + 2.0 * c[5] * v };
}

/// Distance to the tangent plane over y, positive on the side of the second label; gradient: its unit normal.
inline double DistanceTo(const LocalQuadric& s, const Vector3& y, Vector3& gradient)
{
  const QuadricHeight h = HeightAt(s, y);
  const double steep = 1.0 / std::sqrt(1.0 + h.AlongU * h.AlongU + h.AlongV * h.AlongV);
  gradient = steep * (s.N - h.AlongU * s.U - h.AlongV * s.V);
  return steep * (Dot(y - s.Base, s.N) - h.W);
}

/// The point of a surface near y, by so many steps of Newton; normal: unit, where the last began.
inline Vector3 FootOn(const LocalQuadric& s, Vector3 y, int steps, Vector3& normal)
{
  for (int step = 0; step < steps; ++step)
  {
    const double distance = DistanceTo(s, y, normal);
    y = y - distance * normal;
  }
  return y;
}

/// The same surface with its base on it, over or under y.
inline LocalQuadric Recentred(const LocalQuadric& s, const Vector3& y)
{
  const QuadricHeight h = HeightAt(s, y);
  LocalQuadric result = s;
  result.Base = s.Base + h.U * s.U + h.V * s.V + h.W * s.N;
  result.C = { { 0.0, h.AlongU, h.AlongV, s.C[3], s.C[4], s.C[5] } };
  return result;
}

/// The same surface in the frame of a node from which this one's lies at `from`.
inline LocalQuadric Moved(LocalQuadric s, const Vector3& from)
{
  s.Base = s.Base + from;
  return s;
}

} // namespace vfm
