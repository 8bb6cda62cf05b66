/**
 * SIMD types of eight floats or four doubles for the energy kernels, one lane per element, with one
 * source for both types. Only sources of kernels include it: functions that take lanes must be
 * inlined into functions compiled by VFM_CLONES.
 */
#pragma once

#include "Base/Clones.h"
#include "Base/Vector3.h"

#include <algorithm>
#include <cstring>

namespace vfm
{

typedef float Float4 __attribute__((vector_size(16)));
typedef float Float8 __attribute__((vector_size(32)));
typedef double Double4 __attribute__((vector_size(32)));
typedef long long Mask __attribute__((vector_size(32)));

/// Number of lanes, vector type of the lanes and vector type of one point.
template <class Real>
struct ElementLanes;
template <>
struct ElementLanes<float>
{
  static constexpr int Count = 8;
  using Type = Float8;
  using Point = Float4;
};
template <>
struct ElementLanes<double>
{
  static constexpr int Count = 4;
  using Type = Double4;
  using Point = Double4;
};

template <class Real>
using LanesOf = typename ElementLanes<Real>::Type;

/// One vector (x, y, z) per lane.
template <class Real>
struct VectorLanes
{
  LanesOf<Real> X, Y, Z;
};

///@{ Names for code that uses only doubles.
using Lanes = LanesOf<double>;
using Lanes3 = VectorLanes<double>;
///@}

/// Returns lanes that all hold a.
template <class Real>
VFM_INLINE LanesOf<Real> Fill(Real a)
{
  return a - LanesOf<Real>{}; // keeps the sign of a zero
}

/// Reads lanes from consecutive doubles, or writes them.
VFM_INLINE Lanes LoadLanes(const double* from)
{
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}
VFM_INLINE void StoreLanes(const Lanes& lanes, double* to)
{
  std::memcpy(to, &lanes, sizeof(lanes));
}

/// Returns 1 in the first `count` lanes and 0 in the others.
template <class Real>
VFM_INLINE LanesOf<Real> FirstOnes(int count)
{
  constexpr int Count = ElementLanes<Real>::Count;
  LanesOf<Real> lane;
  for (int i = 0; i < Count; ++i)
  {
    lane[i] = Real(i);
  }
  return lane < static_cast<Real>(count) ? Fill<Real>(1.0) : Fill<Real>(0.0);
}

template <class Real>
VFM_INLINE VectorLanes<Real> operator+(const VectorLanes<Real>& a, const VectorLanes<Real>& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
template <class Real>
VFM_INLINE VectorLanes<Real> operator-(const VectorLanes<Real>& a, const VectorLanes<Real>& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
template <class Real>
VFM_INLINE VectorLanes<Real> Times(const LanesOf<Real>& s, const VectorLanes<Real>& a)
{
  return { s * a.X, s * a.Y, s * a.Z };
}
template <class Real>
VFM_INLINE LanesOf<Real> Dot(const VectorLanes<Real>& a, const VectorLanes<Real>& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
template <class Real>
VFM_INLINE VectorLanes<Real> Cross(const VectorLanes<Real>& a, const VectorLanes<Real>& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}

VFM_INLINE Float8 SquareRoot(const Float8& a)
{
  Float8 root;
  for (int i = 0; i < 8; ++i)
  {
    root[i] = std::sqrt(a[i]);
  }
  return root;
}
VFM_INLINE Double4 SquareRoot(const Double4& a)
{
  return Double4{ std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3]) };
}

/// Returns the sum of the lanes, added in the same order on every machine.
VFM_INLINE double Sum(const Float8& a)
{
  const Float4 half =
    __builtin_shufflevector(a, a, 0, 1, 2, 3) + __builtin_shufflevector(a, a, 4, 5, 6, 7);
  return (static_cast<double>(half[0]) + half[1]) + (static_cast<double>(half[2]) + half[3]);
}
VFM_INLINE double Sum(const Double4& a)
{
  return (a[0] + a[1]) + (a[2] + a[3]);
}

/// Returns the smaller or the greater number of each lane.
template <class L>
VFM_INLINE L Least(const L& a, const L& b)
{
  return a < b ? a : b;
}
template <class L>
VFM_INLINE L Greatest(const L& a, const L& b)
{
  return a > b ? a : b;
}

/// Returns the greatest lane.
template <class L>
VFM_INLINE double GreatestLane(const L& a)
{
  auto greatest = a[0];
  for (std::size_t i = 1; i < sizeof(L) / sizeof(a[0]); ++i)
  {
    greatest = std::max(greatest, a[i]);
  }
  return greatest;
}

/// Coordinates x, y, z of one point and an unused fourth number.
template <class Real>
using PointOf = typename ElementLanes<Real>::Point;

/// Returns point - origin, subtracted in double precision.
template <class Real>
VFM_INLINE PointOf<Real> Difference(const Vector3& point, const Vector3& origin)
{
  return __builtin_convertvector(
    (Double4{ point[0] - origin[0], point[1] - origin[1], point[2] - origin[2], 0.0 }),
    PointOf<Real>);
}

/// Returns points[at(lane)] in each lane.
template <class At>
VFM_INLINE VectorLanes<double> GatherPoints(const Double4* points, const At& at)
{
  const Double4 a = points[at(0)], b = points[at(1)], c = points[at(2)], d = points[at(3)];
  const Double4 xz0 = __builtin_shufflevector(a, b, 0, 4, 2, 6),
                xz1 = __builtin_shufflevector(c, d, 0, 4, 2, 6),
                y0 = __builtin_shufflevector(a, b, 1, 5, 3, 7),
                y1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return { __builtin_shufflevector(xz0, xz1, 0, 1, 4, 5),
    __builtin_shufflevector(y0, y1, 0, 1, 4, 5), __builtin_shufflevector(xz0, xz1, 2, 3, 6, 7) };
}
template <class At>
VFM_INLINE VectorLanes<float> GatherPoints(const Float4* points, const At& at)
{
  const auto pair = [&](int lane) {
    return __builtin_shufflevector(points[at(lane)], points[at(lane + 4)], 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const Float8 a = pair(0), b = pair(1), c = pair(2), d = pair(3);
  const Float8 xy0 = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13),
               xy1 = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13),
               z0 = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15),
               z1 = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
  return { __builtin_shufflevector(xy0, xy1, 0, 1, 8, 9, 4, 5, 12, 13),
    __builtin_shufflevector(xy0, xy1, 2, 3, 10, 11, 6, 7, 14, 15),
    __builtin_shufflevector(z0, z1, 0, 1, 8, 9, 4, 5, 12, 13) };
}

/// Returns points[i] - origin in lane i, subtracted in double precision.
VFM_INLINE VectorLanes<double> Differences(const double* const (&points)[4], const Vector3& origin)
{
  const auto along = [&](int a) {
    return Double4{ points[0][a], points[1][a], points[2][a], points[3][a] } - origin[a];
  };
  return { along(0), along(1), along(2) };
}

/// Sum of gradients and of Hessians (xx yy zz xy xz yz).
template <class Real>
struct DerivativeSums
{
  VectorLanes<Real> Gradient;
  LanesOf<Real> XX, YY, ZZ, XY, XZ, YZ;

  /// Adds a b^T + c d^T, which must be symmetric.
  VFM_INLINE void AddOuter(const VectorLanes<Real>& a, const VectorLanes<Real>& b,
    const VectorLanes<Real>& c, const VectorLanes<Real>& d)
  {
    this->XX += a.X * b.X + c.X * d.X;
    this->YY += a.Y * b.Y + c.Y * d.Y;
    this->ZZ += a.Z * b.Z + c.Z * d.Z;
    this->XY += a.X * b.Y + c.X * d.Y;
    this->XZ += a.X * b.Z + c.X * d.Z;
    this->YZ += a.Y * b.Z + c.Y * d.Z;
  }
};

} // namespace vfm
