/**
 * CellSums: volume and first moments of the part of a solid in a cell, summed over pieces of the
 * solid's surface, which are triangles.
 */
#pragma once

#include "Base/Vector3.h"

namespace vfm
{

/// Returns the point where an edge crosses a plane. It is computed from the lower end of the edge,
/// so it is bitwise identical in both triangles at the edge.
template <int Axis>
Vector3 CutEdge(const Vector3& a, const Vector3& b, double plane)
{
  const bool rises = a[Axis] < b[Axis];
  const Vector3 &low = rises ? a : b, &high = rises ? b : a;
  Vector3 cut = low + (plane - low[Axis]) / (high[Axis] - low[Axis]) * (high - low);
  cut[Axis] = plane;
  return cut;
}

/// Sums in a cell over pieces of an element's surface.
struct CellSums
{
  // Volume and first moments, times 6, 24, 24, 24 for cones and 6, 24, 24, 48 for columns.
  double Volume = 0.0, X = 0.0, Y = 0.0, Z = 0.0;
  // Area and first moments of shadows, times 2, 6, 6.
  double Area = 0.0, AreaX = 0.0, AreaY = 0.0;

  /// Adds the tet between the origin and a triangle.
  void AddCone(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const double volume = Dot(a, Cross(b, c));
    this->Volume += volume;
    this->X += volume * (a[0] + b[0] + c[0]);
    this->Y += volume * (a[1] + b[1] + c[1]);
    this->Z += volume * (a[2] + b[2] + c[2]);
  }

  /// Adds the column along z between a triangle and z = 0.
  void AddColumn(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const double area = TwiceShadow(a, b, c);
    const double x = a[0] + b[0] + c[0], y = a[1] + b[1] + c[1], z = a[2] + b[2] + c[2];
    this->Volume += area * z;
    this->X += area * (x * z + a[0] * a[2] + b[0] * b[2] + c[0] * c[2]);
    this->Y += area * (y * z + a[1] * a[2] + b[1] * b[2] + c[1] * c[2]);
    this->Z += area * (z * z + a[2] * a[2] + b[2] * b[2] + c[2] * c[2]);
  }

  /// Adds the shadow of a triangle, its projection along z.
  void AddShadow(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const double area = TwiceShadow(a, b, c);
    this->Area += area;
    this->AreaX += area * (a[0] + b[0] + c[0]);
    this->AreaY += area * (a[1] + b[1] + c[1]);
  }

private:
  static double TwiceShadow(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
};

} // namespace vfm
