/**
 * Four doubles side by side, for the kernels of the energies. Only for their sources: functions that take lanes
 * must be inlined into those compiled by VFM_CLONES.
 */
#pragma once

#include "Base/Clones.h"
#include "Base/Vector3.h"

namespace vfm
{

typedef double Lanes __attribute__((vector_size(32)));
typedef long long Mask __attribute__((vector_size(32)));

struct Lanes3
{
  Lanes X, Y, Z;
};

VFM_INLINE Lanes Splat(double a)
{
  return Lanes{ a, a, a, a };
}
VFM_INLINE Lanes SquareRoot(const Lanes& a)
{
  return Lanes{ std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3]) };
}
VFM_INLINE Lanes3 Plus(const Lanes3& a, const Lanes3& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
VFM_INLINE Lanes3 Minus(const Lanes3& a, const Lanes3& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
VFM_INLINE Lanes3 Times(const Lanes& s, const Lanes3& a)
{
  return { s * a.X, s * a.Y, s * a.Z };
}
VFM_INLINE Lanes3 Times(const Lanes3& a, const Lanes3& b)
{
  return { a.X * b.X, a.Y * b.Y, a.Z * b.Z };
}
VFM_INLINE Lanes Dot(const Lanes3& a, const Lanes3& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
VFM_INLINE Lanes3 Cross(const Lanes3& a, const Lanes3& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
VFM_INLINE double Sum(const Lanes& a)
{
  return (a[0] + a[1]) + (a[2] + a[3]);
}
VFM_INLINE Lanes3 Pack(const double* a, const double* b, const double* c, const double* d)
{
  return { Lanes{ a[0], b[0], c[0], d[0] }, Lanes{ a[1], b[1], c[1], d[1] },
    Lanes{ a[2], b[2], c[2], d[2] } };
}

/// A sum of values, gradients and Hessians.
struct Accumulator
{
  Lanes Value, GX, GY, GZ, XX, YY, ZZ, XY, XZ, YZ;
};

VFM_INLINE void AddOuter(Accumulator& sum, const Lanes& weight, const Lanes3& a)
{
  const Lanes3 wa = Times(weight, a);
  sum.XX += wa.X * a.X;
  sum.YY += wa.Y * a.Y;
  sum.ZZ += wa.Z * a.Z;
  sum.XY += wa.X * a.Y;
  sum.XZ += wa.X * a.Z;
  sum.YZ += wa.Y * a.Z;
}

VFM_INLINE void AddGradient(Accumulator& sum, const Lanes& weight, const Lanes3& a)
{
  sum.GX += weight * a.X;
  sum.GY += weight * a.Y;
  sum.GZ += weight * a.Z;
}

} // namespace vfm
