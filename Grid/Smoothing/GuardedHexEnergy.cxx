#include "Smoothing/GuardedHexEnergy.h"

#include "Base/Lanes.h"

namespace vfm
{
namespace
{

constexpr double LeastCoefficient = 1e-6; // in cell volumes

using Corners = std::array<const double*, 8>; // of a hex, by bits

/// The Jacobian of a trilinear hex is the sum of all products dx . (dy x dz) of three of its edges, one along each axis.
/// An edge has a position, 0 or 1, along each of the two other axes. The sums of these, along each axis of two edges, are the
/// indices of the coefficient to which the product adds: 0, 1 or 2 along each axis, 27 in all. Lanes: of the edges along z, by
/// the corner at their lower end.
struct EdgeProducts
{
  /// By the position of the y edge along x, of the x edge along y, and the sum of both along z.
  Lanes Of[2][2][3];
};

VFM_INLINE Lanes3 SplatEdge(const double* from, const double* to)
{
  return { Splat(to[0] - from[0]), Splat(to[1] - from[1]), Splat(to[2] - from[2]) };
}

VFM_INLINE EdgeProducts MakeProducts(const Corners& c)
{
  const Lanes3 dz = Minus(Pack(c[4], c[5], c[6], c[7]), Pack(c[0], c[1], c[2], c[3]));
  Lanes3 dx[2][2]; // along y, z
  for (int v = 0; v < 2; ++v)
  {
    for (int w = 0; w < 2; ++w)
    {
      dx[v][w] = SplatEdge(c[2 * v + 4 * w], c[1 + 2 * v + 4 * w]);
    }
  }
  EdgeProducts products;
  for (int u = 0; u < 2; ++u)
  {
    const Lanes3 low = Cross(SplatEdge(c[u], c[u + 2]), dz);
    const Lanes3 high = Cross(SplatEdge(c[u + 4], c[u + 6]), dz);
    for (int v = 0; v < 2; ++v)
    {
      products.Of[u][v][0] = Dot(dx[v][0], low);
      products.Of[u][v][1] = Splat(0.5) * (Dot(dx[v][0], high) + Dot(dx[v][1], low));
      products.Of[u][v][2] = Dot(dx[v][1], high);
    }
  }
  return products;
}

/// No coefficient is smaller.
VFM_INLINE double BoundOf(const EdgeProducts& products)
{
  Lanes least = products.Of[0][0][0];
  for (int n = 1; n < 12; ++n)
  {
    const Lanes& other = products.Of[n / 6][n / 3 % 2][n % 3];
    least = other < least ? other : least;
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

/// Of the hex at a position of the corner list when the point there stands at x.
VFM_INLINE EdgeProducts ProductsAt(const ActiveMesh& mesh, Index position, const Vector3& x)
{
  Corners corners;
  const int* hex = mesh.Elements.data() + (position & ~7);
  for (int c = 0; c < 8; ++c)
  {
    corners[c] = mesh.X[hex[c]].data();
  }
  corners[position & 7] = x.data();
  return MakeProducts(corners);
}

/// Whether no hex at a point gets a coefficient that is too small, or none smaller than now, when the point stands at x.
VFM_CLONES
bool MayStandAt(const ActiveMesh& mesh, int point, const Vector3& x)
{
  for (Index at = mesh.CornerOffset[point]; at < mesh.CornerOffset[point + 1]; ++at)
  {
    const Index position = mesh.CornerList[at];
    const Vector3& widths = mesh.WidthsAt(position);
    const double least = LeastCoefficient * widths[0] * widths[1] * widths[2];
    const EdgeProducts products = ProductsAt(mesh, position, x);
    if (BoundOf(products) > least)
    {
      continue;
    }
    const double smallest = SmallestOf(products);
    if (!(smallest > least || smallest >= SmallestOf(ProductsAt(mesh, position, mesh.X[point]))))
    {
      return false;
    }
  }
  return true;
}

VFM_CLONES
double FindSmallest(const Corners& corners)
{
  return SmallestOf(MakeProducts(corners));
}

} // namespace

double SmallestCoefficient(const std::array<Vector3, 8>& corners)
{
  Corners pointers;
  for (int c = 0; c < 8; ++c)
  {
    pointers[c] = corners[c].data();
  }
  return FindSmallest(pointers);
}

double GuardedHexEnergy::Evaluate(
  const ActiveMesh& mesh, int point, const Vector3& x, const SmoothingStage& stage) const
{
  const double energy = this->HexEnergy::Evaluate(mesh, point, x, stage);
  return energy == InvalidEnergy || MayStandAt(mesh, point, x) ? energy : InvalidEnergy;
}

} // namespace vfm
