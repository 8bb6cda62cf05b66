/**
 * FlatPlane: vectors in the plane of a layer, and the better diagonal of a quad there.
 */
#pragma once

#include "Base/Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vfm
{

/// A vector of a plane.
struct FlatVector
{
  double U, V;
};

inline FlatVector operator-(const FlatVector& a, const FlatVector& b)
{
  return { a.U - b.U, a.V - b.V };
}

inline double Dot(const FlatVector& a, const FlatVector& b)
{
  return a.U * b.U + a.V * b.V;
}

inline double Cross(const FlatVector& a, const FlatVector& b)
{
  return a.U * b.V - a.V * b.U;
}

/// The axes of a plane; with the axis across it, 0 to 2, they are right-handed.
struct FlatPlane
{
  explicit FlatPlane(int axis) : Axis(axis), U((axis + 1) % 3), V((axis + 2) % 3) {}
  /// @param x  three coordinates that [] gives
  template <class Point>
  FlatVector At(const Point& x) const
  {
    return { x[this->U], x[this->V] };
  }
  int Axis, U, V;
};

/// Returns the sine of the smallest angle of a triangle; negative if it is clockwise.
inline double SmallestSine(const FlatVector& a, const FlatVector& b, const FlatVector& c)
{
  const FlatVector ab = b - a, bc = c - b, ca = a - c;
  const double l[3] = { Dot(ab, ab), Dot(bc, bc), Dot(ca, ca) };
  const double shortest = std::min({ l[0], l[1], l[2] });
  // The smallest angle is between the two longer edges.
  const double product = l[0] * l[1] * l[2] / shortest;
  return product > 0.0 ? -Cross(ab, ca) / std::sqrt(product) : 0.0;
}

/// Sines of the smallest angles of a quad that is divided from corner 0 to 2, and from 1 to 3.
/// @param quad  corners, counterclockwise
inline std::array<double, 2> SinesOfDiagonals(const std::array<FlatVector, 4>& quad)
{
  const auto of = [&quad](int a, int b, int c) { return SmallestSine(quad[a], quad[b], quad[c]); };
  return { { std::min(of(0, 1, 2), of(0, 2, 3)), std::min(of(0, 1, 3), of(1, 2, 3)) } };
}

} // namespace vfm
