#include "MeshChecks.h"

#include "Base/Vector3.h"
#include "Elements/Hex/HexTopology.h"
#include "Report/MeshArrays.h"

#include <algorithm>
#include <cstring>
#include <random>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

using Corners = std::array<Vector3, 8>; // in the order of corner bits

using TetCorners = std::array<Vector3, 4>;

TetCorners TetCornersOf(const Mesh& mesh, Index tet)
{
  TetCorners x;
  for (int c = 0; c < 4; ++c)
  {
    const double* p = mesh.Points.data() + 3 * mesh.Elements[4 * tet + c];
    x[c] = { { p[0], p[1], p[2] } };
  }
  return x;
}

double SixVolumes(const TetCorners& x)
{
  return Dot(x[1] - x[0], Cross(x[2] - x[0], x[3] - x[0]));
}

/// Returns corners relative to the first: nothing cancels far from the origin.
Corners CornersOf(const Mesh& mesh, Index hex)
{
  Corners x;
  const double* first = mesh.Points.data() + 3 * mesh.Elements[8 * hex];
  for (int c = 0; c < 8; ++c)
  {
    const double* p = mesh.Points.data() + 3 * mesh.Elements[8 * hex + VtkCorner[c]];
    x[c] = { { p[0] - first[0], p[1] - first[1], p[2] - first[2] } };
  }
  return x;
}

/// Returns the derivative of the trilinear map along an axis.
Vector3 Derivative(const Corners& x, int axis, const Vector3& at)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int c = 0; c < 8; ++c)
  {
    double weight = c >> axis & 1 ? 1.0 : -1.0;
    for (int a = 0; a < 3; ++a)
    {
      weight *= a == axis ? 1.0 : (c >> a & 1 ? at[a] : 1.0 - at[a]);
    }
    sum = sum + weight * x[c];
  }
  return sum;
}

double Jacobian(const Corners& x, const Vector3& at)
{
  return Dot(Derivative(x, 0, at), Cross(Derivative(x, 1, at), Derivative(x, 2, at)));
}

/// Returns the smallest of the 27 Bernstein coefficients of the Jacobian in the
/// box [low, high] of the unit cube.
double SmallestCoefficient(const Corners& x, const Vector3& low, const Vector3& high)
{
  double b[3][3][3];
  for (int i = 0; i < 27; ++i)
  {
    const Vector3 t{ { 0.5 * (i % 3), 0.5 * (i / 3 % 3), 0.5 * (i / 9) } };
    b[i / 9][i / 3 % 3][i % 3] = Jacobian(x, low + Scaled(t, high - low));
  }
  // Converts values at 0, 1/2 and 1 to coefficients: the middle one is
  // 2 f(1/2) - (f(0) + f(1)) / 2.
  double smallest = 1e300;
  for (int p = 0; p < 3; ++p)
  {
    for (int q = 0; q < 3; ++q)
    {
      b[p][q][1] = 2.0 * b[p][q][1] - 0.5 * (b[p][q][0] + b[p][q][2]);
    }
  }
  for (int p = 0; p < 3; ++p)
  {
    for (int q = 0; q < 3; ++q)
    {
      b[p][1][q] = 2.0 * b[p][1][q] - 0.5 * (b[p][0][q] + b[p][2][q]);
    }
  }
  for (int p = 0; p < 3; ++p)
  {
    for (int q = 0; q < 3; ++q)
    {
      b[1][p][q] = 2.0 * b[1][p][q] - 0.5 * (b[0][p][q] + b[2][p][q]);
      smallest = std::min({ smallest, b[0][p][q], b[1][p][q], b[2][p][q] });
    }
  }
  return smallest;
}

bool IsPositive(const Corners& x, const Vector3& low, const Vector3& high, int depth)
{
  if (SmallestCoefficient(x, low, high) > 0.0)
  {
    return true;
  }
  if (depth == 0)
  {
    return false;
  }
  const Vector3 half = 0.5 * (high - low);
  for (int c = 0; c < 8; ++c)
  {
    const Vector3 from{ { low[0] + (c & 1) * half[0], low[1] + (c >> 1 & 1) * half[1],
      low[2] + (c >> 2 & 1) * half[2] } };
    if (!IsPositive(x, from, from + half, depth - 1))
    {
      return false;
    }
  }
  return true;
}

template <class T>
bool SameContent(const Buffer<T>& a, const Buffer<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

} // namespace

CartesianGrid MakeUnitGrid(Index nx, Index ny, Index nz)
{
  std::array<std::vector<double>, 3> x;
  const Index n[3] = { nx, ny, nz };
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= n[a]; ++i)
    {
      x[a].push_back(static_cast<double>(i));
    }
  }
  return CartesianGrid(x);
}

FractionField MakeLabels(
  const CartesianGrid& grid, int materials, const std::function<int(const Index3&)>& label)
{
  FractionField field(grid, materials);
  const IndexBox& box = grid.Local();
  FractionField::RowWriter row(field);
  ForRows(box,
    [&](Index j, Index k)
    {
      Index3 p{ { box.Lower[0], j, k } };
      row.Start(grid.Linear(p));
      for (; p[0] < box.Upper[0]; ++p[0])
      {
        row.AddLabel(label(p));
      }
      row.Finish();
    });
  return field;
}

FractionField MakeRandomLabels(const CartesianGrid& grid, int materials, int lowest, unsigned seed)
{
  std::mt19937 engine(seed);
  return MakeLabels(grid, materials,
    [&](const Index3&) { return lowest + static_cast<int>(engine() % (materials + 1 - lowest)); });
}

double SmallestCornerDeterminant(const Mesh& mesh)
{
  double smallest = 1e300;
  for (Index e = 0; e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    if (mesh.Corners == 4)
    {
      smallest = std::min(smallest, SixVolumes(TetCornersOf(mesh, e)));
      continue;
    }
    const Corners x = CornersOf(mesh, e);
    for (int c = 0; c < 8; ++c)
    {
      smallest = std::min(
        smallest, Jacobian(x, { { 1.0 * (c & 1), 1.0 * (c >> 1 & 1), 1.0 * (c >> 2 & 1) } }));
    }
  }
  return smallest;
}

bool IsPositiveEverywhere(const Mesh& mesh)
{
  if (mesh.Corners == 4)
  {
    return SmallestCornerDeterminant(mesh) > 0.0;
  }
  for (std::size_t h = 0; h < mesh.ElementIds.size(); ++h)
  {
    if (!IsPositive(CornersOf(mesh, static_cast<Index>(h)), { { 0, 0, 0 } }, { { 1, 1, 1 } }, 4))
    {
      return false;
    }
  }
  return true;
}

double SmallestCoefficient(const Mesh& mesh, Index element)
{
  return mesh.Corners == 4
    ? SixVolumes(TetCornersOf(mesh, element))
    : SmallestCoefficient(CornersOf(mesh, element), { { 0, 0, 0 } }, { { 1, 1, 1 } });
}

double MeasureVolume(const Mesh& mesh, int material)
{
  const double low = 0.5 - 0.5 / std::sqrt(3.0);
  long double volume = 0.0L; // in double, the error of 100,000 summands would be visible
  for (Index e = 0; e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    if (mesh.Material[e] != material)
    {
      continue;
    }
    if (mesh.Corners == 4)
    {
      volume += SixVolumes(TetCornersOf(mesh, e)) / 6.0;
      continue;
    }
    const Corners x = CornersOf(mesh, e);
    for (int g = 0; g < 8; ++g)
    {
      volume +=
        Jacobian(x, { { g & 1 ? 1 - low : low, g & 2 ? 1 - low : low, g & 4 ? 1 - low : low } }) /
        8.0;
    }
  }
  return static_cast<double>(volume);
}

Distances MeasureDistances(const Mesh& mesh, const std::function<double(const Vector3&)>& distance)
{
  const int corners = mesh.CornersOfFacet();
  std::set<Index> points;
  for (std::size_t q = 0; q < mesh.Surfaces.DomainSide.size(); ++q)
  {
    if (mesh.Surfaces.DomainSide[q] < 0)
    {
      const Index* facet = mesh.Surfaces.Points.data() + corners * q;
      points.insert(facet, facet + corners);
    }
  }
  Distances result;
  for (Index p : points)
  {
    const double* x = mesh.Points.data() + 3 * p;
    const double d = std::fabs(distance({ { x[0], x[1], x[2] } }));
    result.Largest = std::max(result.Largest, d);
    result.RootMeanSquare += d * d / static_cast<double>(points.size());
  }
  result.RootMeanSquare = std::sqrt(result.RootMeanSquare);
  return result;
}

bool AreEqual(const Mesh& a, const Mesh& b)
{
  bool areEqual = true;
  const auto compare = [&areEqual](const KnownArray&, const auto& first, const auto& second)
  { areEqual = areEqual && SameContent(first, second); };
  VisitPointArrays(compare, a, b);
  VisitElementArrays(compare, a, b);
  return areEqual && a.Corners == b.Corners && SameContent(a.Points, b.Points) &&
    SameContent(a.Elements, b.Elements) && SameContent(a.Surfaces.Points, b.Surfaces.Points) &&
    SameContent(a.Surfaces.SurfaceId, b.Surfaces.SurfaceId) &&
    SameContent(a.Surfaces.MaterialPair, b.Surfaces.MaterialPair) &&
    SameContent(a.Surfaces.DomainSide, b.Surfaces.DomainSide) &&
    SameContent(a.Curves.Points, b.Curves.Points) &&
    SameContent(a.Curves.CurveId, b.Curves.CurveId) &&
    SameContent(a.Vertices.Points, b.Vertices.Points) &&
    SameContent(a.Vertices.VertexId, b.Vertices.VertexId) && a.Tables == b.Tables;
}

} // namespace testing
} // namespace vfm
