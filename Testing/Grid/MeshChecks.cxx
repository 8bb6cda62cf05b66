#include "MeshChecks.h"

#include "HexTopology.h"
#include "Vector3.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <random>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

using Corners = std::array<Vector3, 8>; // by bits

Corners CornersOf(const HexMesh& mesh, Index hex)
{
  Corners x;
  for (int c = 0; c < 8; ++c)
  {
    const double* p = mesh.Points.data() + 3 * mesh.Hexes[8 * hex + VtkCorner[c]];
    x[c] = { { p[0], p[1], p[2] } };
  }
  return x;
}

/// Derivative of the trilinear map along an axis.
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

/// Smallest of the 27 Bernstein coefficients of the Jacobian in the box [low, high] of the unit cube.
double SmallestCoefficient(const Corners& x, const Vector3& low, const Vector3& high)
{
  double b[3][3][3];
  for (int i = 0; i < 27; ++i)
  {
    const Vector3 t{ { 0.5 * (i % 3), 0.5 * (i / 3 % 3), 0.5 * (i / 9) } };
    b[i / 9][i / 3 % 3][i % 3] = Jacobian(x, low + Scaled(t, high - low));
  }
  // values at 0, 1/2, 1 to coefficients: the middle one is 2 f(1/2) - (f(0) + f(1)) / 2
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

using Face = std::array<Index, 4>;

constexpr int HexFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
  { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };

/// The hexes of every face, by its sorted points.
std::map<Face, std::vector<Index>> FacesOf(const HexMesh& mesh)
{
  std::map<Face, std::vector<Index>> faces;
  for (std::size_t h = 0; h < mesh.HexIds.size(); ++h)
  {
    for (const auto& corners : HexFaces)
    {
      Face face;
      for (int c = 0; c < 4; ++c)
      {
        face[c] = mesh.Hexes[8 * h + corners[c]];
      }
      std::sort(face.begin(), face.end());
      faces[face].push_back(6 * static_cast<Index>(h) + (&corners - HexFaces));
    }
  }
  return faces;
}

/// Each edge on exactly two quads, and the quads at a point connected over the edges at it.
std::string FindSurfaceProblem(const std::vector<Face>& quads)
{
  std::map<std::pair<Index, Index>, std::vector<int>> edges;
  std::map<Index, std::vector<int>> fans;
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      edges[std::minmax(quads[q][c], quads[q][(c + 1) % 4])].push_back(static_cast<int>(q));
      fans[quads[q][c]].push_back(static_cast<int>(q));
    }
  }
  for (const auto& edge : edges)
  {
    if (edge.second.size() != 2)
    {
      return "an edge on " + std::to_string(edge.second.size()) + " faces";
    }
  }
  for (const auto& fan : fans)
  {
    std::set<int> reached{ fan.second[0] };
    std::vector<int> front{ fan.second[0] };
    while (!front.empty())
    {
      const int q = front.back();
      front.pop_back();
      for (int c = 0; c < 4; ++c)
      {
        const Index a = quads[q][c], b = quads[q][(c + 1) % 4];
        if (a == fan.first || b == fan.first)
        {
          for (int other : edges[std::minmax(a, b)])
          {
            if (reached.insert(other).second)
            {
              front.push_back(other);
            }
          }
        }
      }
    }
    if (reached.size() != fan.second.size())
    {
      return "a pinched point";
    }
  }
  return "";
}

template <class T>
bool SameContent(const Buffer<T>& a, const Buffer<T>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

template <class T>
bool AreUnique(const Buffer<T>& ids)
{
  return std::set<T>(ids.begin(), ids.end()).size() == ids.size();
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
  const IndexBox& box = grid.Owned();
  Index3 p;
  for (p[2] = 0; p[2] < box.Upper[2]; ++p[2])
  {
    for (p[1] = 0; p[1] < box.Upper[1]; ++p[1])
    {
      for (p[0] = 0; p[0] < box.Upper[0]; ++p[0])
      {
        field.SetLabel(grid.Linear(p), label(p));
      }
    }
  }
  return field;
}

FractionField MakeRandomLabels(const CartesianGrid& grid, int materials, int lowest, unsigned seed)
{
  std::mt19937 engine(seed);
  return MakeLabels(grid, materials,
    [&](const Index3&) { return lowest + static_cast<int>(engine() % (materials + 1 - lowest)); });
}

double SmallestCornerDeterminant(const HexMesh& mesh)
{
  double smallest = 1e300;
  for (std::size_t h = 0; h < mesh.HexIds.size(); ++h)
  {
    const Corners x = CornersOf(mesh, static_cast<Index>(h));
    for (int c = 0; c < 8; ++c)
    {
      smallest = std::min(
        smallest, Jacobian(x, { { 1.0 * (c & 1), 1.0 * (c >> 1 & 1), 1.0 * (c >> 2 & 1) } }));
    }
  }
  return smallest;
}

bool IsPositiveEverywhere(const HexMesh& mesh)
{
  for (std::size_t h = 0; h < mesh.HexIds.size(); ++h)
  {
    if (!IsPositive(CornersOf(mesh, static_cast<Index>(h)), { { 0, 0, 0 } }, { { 1, 1, 1 } }, 4))
    {
      return false;
    }
  }
  return true;
}

std::string FindTopologyProblem(const HexMesh& mesh)
{
  if (!AreUnique(mesh.HexIds) || !AreUnique(mesh.PointIds))
  {
    return "global ids are not unique";
  }
  const std::set<Index> used(mesh.Hexes.begin(), mesh.Hexes.end());
  if (used.size() != mesh.PointIds.size() || (used.size() && *used.begin() < 0))
  {
    return "unused points";
  }
  std::map<int, std::vector<Face>> boundaries;
  for (const auto& face : FacesOf(mesh))
  {
    if (face.second.size() > 2)
    {
      return "a face on more than two hexes";
    }
    const int first = mesh.Material[face.second[0] / 6];
    const int last = face.second.size() == 2 ? mesh.Material[face.second[1] / 6] : -1;
    Face quad;
    for (int c = 0; c < 4; ++c)
    {
      quad[c] = mesh.Hexes[8 * (face.second[0] / 6) + HexFaces[face.second[0] % 6][c]];
    }
    for (int material : { first, last })
    {
      if (first != last && material >= 0)
      {
        boundaries[material].push_back(quad);
      }
    }
  }
  for (const auto& boundary : boundaries)
  {
    const std::string problem = FindSurfaceProblem(boundary.second);
    if (!problem.empty())
    {
      return "boundary of material " + std::to_string(boundary.first) + ": " + problem;
    }
  }
  return "";
}

double MeasureVolume(const HexMesh& mesh, int material)
{
  const double low = 0.5 - 0.5 / std::sqrt(3.0);
  double volume = 0.0;
  for (std::size_t h = 0; h < mesh.HexIds.size(); ++h)
  {
    if (mesh.Material[h] == material)
    {
      const Corners x = CornersOf(mesh, static_cast<Index>(h));
      for (int g = 0; g < 8; ++g)
      {
        volume +=
          Jacobian(x, { { g & 1 ? 1 - low : low, g & 2 ? 1 - low : low, g & 4 ? 1 - low : low } }) /
          8.0;
      }
    }
  }
  return volume;
}

Distances MeasureDistances(
  const HexMesh& mesh, const std::function<double(const Vector3&)>& distance)
{
  std::set<Index> points;
  for (std::size_t q = 0; q < mesh.Surfaces.DomainSide.size(); ++q)
  {
    if (mesh.Surfaces.DomainSide[q] < 0)
    {
      points.insert(mesh.Surfaces.Points.data() + 4 * q, mesh.Surfaces.Points.data() + 4 * q + 4);
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

bool AreEqual(const HexMesh& a, const HexMesh& b)
{
  return SameContent(a.Points, b.Points) && SameContent(a.PointIds, b.PointIds) &&
    SameContent(a.Hexes, b.Hexes) && SameContent(a.HexIds, b.HexIds) &&
    SameContent(a.Material, b.Material) && SameContent(a.Fragment, b.Fragment) &&
    SameContent(a.GeometryDimension, b.GeometryDimension) &&
    SameContent(a.GeometryId, b.GeometryId) && SameContent(a.ScaledJacobian, b.ScaledJacobian) &&
    SameContent(a.Surfaces.Points, b.Surfaces.Points) &&
    SameContent(a.Surfaces.SurfaceId, b.Surfaces.SurfaceId) &&
    SameContent(a.Surfaces.MaterialPair, b.Surfaces.MaterialPair) &&
    SameContent(a.Surfaces.DomainSide, b.Surfaces.DomainSide);
}

} // namespace testing
} // namespace vfm
