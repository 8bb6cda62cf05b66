/**
 * EdgeProducts: computes the coefficients of HexCoefficients.h in lanes, as inline functions.
 */
#pragma once

#include "Base/Lanes.h"

#include <algorithm>
#include <array>

namespace vfm
{

using HexCorners = std::array<const double*, 8>; // corners of a hex, by bits

/// Four edges along each axis. Lanes: bits (z, y) of the position for edges along x, (z, x) for
/// edges along y, (x, y) for edges along z.
struct HexEdges
{
  Lanes3 X, Y, Z;
};

VFM_INLINE void SplitEdges(const Lanes& low, const Lanes& high, Lanes& x, Lanes& y, Lanes& z)
{
  x =
    __builtin_shufflevector(low, high, 1, 5, 3, 7) - __builtin_shufflevector(low, high, 0, 4, 2, 6);
  y =
    __builtin_shufflevector(low, high, 2, 6, 3, 7) - __builtin_shufflevector(low, high, 0, 4, 1, 5);
  z = high - low;
}

VFM_INLINE Lanes3 Pack(const double* const* points)
{
  const auto along = [points](int a) {
    return Lanes{ points[0][a], points[1][a], points[2][a], points[3][a] };
  };
  return { along(0), along(1), along(2) };
}

VFM_INLINE HexEdges MakeEdges(const HexCorners& c)
{
  const Lanes3 low = Pack(c.data()), high = Pack(c.data() + 4);
  HexEdges e;
  SplitEdges(low.X, high.X, e.X.X, e.Y.X, e.Z.X);
  SplitEdges(low.Y, high.Y, e.X.Y, e.Y.Y, e.Z.Y);
  SplitEdges(low.Z, high.Z, e.X.Z, e.Y.Z, e.Z.Z);
  return e;
}

/// Products dx . (dy x dz) of three edges of a hex, one along each axis. An edge has a position, 0
/// or 1, along each of the two other axes. Along each axis, the sum of the positions of two edges,
/// 0, 1 or 2, is an index of the coefficient to which the product contributes. There are 27
/// coefficients. Lanes: edges along z.
struct EdgeProducts
{
  /// Indices: position of the y edge along x, position of the x edge along y, sum of the positions
  /// of both along z.
  Lanes Of[2][2][3];
};

template <int N>
VFM_INLINE Lanes3 SplatLane(const Lanes3& a)
{
  return { __builtin_shufflevector(a.X, a.X, N, N, N, N),
    __builtin_shufflevector(a.Y, a.Y, N, N, N, N), __builtin_shufflevector(a.Z, a.Z, N, N, N, N) };
}

/// Computes the products of two y edges at one position along x, low and high along z, with all x
/// and z edges.
VFM_INLINE void AddProducts(
  const HexEdges& edges, const Lanes3& low, const Lanes3& high, Lanes products[2][3])
{
  const Lanes3 first = Cross(low, edges.Z), second = Cross(high, edges.Z);
  const auto add = [&](const Lanes3& lowX, const Lanes3& highX, Lanes* of)
  {
    of[0] = Dot(lowX, first);
    of[1] = 0.5 * (Dot(lowX, second) + Dot(highX, first));
    of[2] = Dot(highX, second);
  };
  add(SplatLane<0>(edges.X), SplatLane<1>(edges.X), products[0]);
  add(SplatLane<2>(edges.X), SplatLane<3>(edges.X), products[1]);
}

VFM_INLINE EdgeProducts MakeProducts(const HexEdges& edges)
{
  EdgeProducts products;
  AddProducts(edges, SplatLane<0>(edges.Y), SplatLane<1>(edges.Y), products.Of[0]);
  AddProducts(edges, SplatLane<2>(edges.Y), SplatLane<3>(edges.Y), products.Of[1]);
  return products;
}

VFM_INLINE Lanes MinOf(const Lanes& a, const Lanes& b)
{
  return a < b ? a : b;
}

/// Returns a lower bound of all coefficients.
VFM_INLINE double BoundOf(const EdgeProducts& products)
{
  Lanes least = products.Of[0][0][0];
  for (int n = 1; n < 12; ++n)
  {
    least = MinOf(least, products.Of[n / 6][n / 3 % 2][n % 3]);
  }
  return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

VFM_INLINE double SmallestOf(const EdgeProducts& products)
{
  double smallest = 1e300;
  for (int k = 0; k < 3; ++k)
  {
    double sums[3][3]{};
    for (int n = 0; n < 16; ++n)
    {
      sums[(n & 1) + (n >> 2 & 1)][(n >> 1 & 1) + (n >> 3)] +=
        products.Of[n >> 2 & 1][n >> 3][k][n & 3];
    }
    for (int n = 0; n < 9; ++n)
    {
      const double weight = (n % 3 == 1 ? 0.5 : 1.0) * (n / 3 == 1 ? 0.5 : 1.0);
      smallest = std::min(smallest, weight * sums[n % 3][n / 3]);
    }
  }
  return smallest;
}

/// Returns whether all coefficients exceed a value.
VFM_INLINE bool Exceeds(const EdgeProducts& products, double least)
{
  return BoundOf(products) > least || SmallestOf(products) > least;
}

} // namespace vfm
