/**
 * Small vector arithmetic on std::array<double, 3>.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <cmath>

namespace vfm
{

inline Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}
inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}
inline Vector3 operator*(double s, const Vector3& a)
{
  return { { s * a[0], s * a[1], s * a[2] } };
}
inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}
inline double Norm(const Vector3& a)
{
  return std::sqrt(Dot(a, a));
}
/// Returns a / |a|, or a itself if it is zero.
inline Vector3 Unit(const Vector3& a)
{
  const double norm = Norm(a);
  return norm > 0.0 ? (1.0 / norm) * a : a;
}
/// Scaled and Divided return the product and the quotient by component.
inline Vector3 Scaled(const Vector3& a, const Vector3& b)
{
  return { { a[0] * b[0], a[1] * b[1], a[2] * b[2] } };
}
inline Vector3 Divided(const Vector3& a, const Vector3& b)
{
  return { { a[0] / b[0], a[1] / b[1], a[2] / b[2] } };
}
/// Sets u and v to unit vectors that are orthogonal to n and to each other.
/// @param n  unit vector
inline void MakeTangents(const Vector3& n, Vector3& u, Vector3& v)
{
  int flat = 0;
  for (int a = 1; a < 3; ++a)
  {
    flat = std::fabs(n[a]) < std::fabs(n[flat]) ? a : flat;
  }
  Vector3 axis{ { 0.0, 0.0, 0.0 } };
  axis[flat] = 1.0;
  u = Unit(Cross(n, axis));
  v = Cross(n, u);
}

} // namespace vfm
