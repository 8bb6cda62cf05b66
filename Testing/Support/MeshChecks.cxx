#include "MeshChecks.h"

#include "Base/Vector3.h"
#include "Hex/HexTopology.h"

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

using Corners = std::array<Vector3, 8>; // by bits

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

/// From the first corner: nothing cancels far from the origin.
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

/// Points of a face; of triangles the last is -1.
using Face = std::array<Index, 4>;

/// Local corners of the faces of an element, in turn.
constexpr int HexFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
  { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
constexpr int TetFaces[4][4] = { { 1, 2, 3, -1 }, { 0, 3, 2, -1 }, { 0, 1, 3, -1 },
  { 0, 2, 1, -1 } };

int CountFaces(const Mesh& mesh)
{
  return mesh.Corners == 8 ? 6 : 4;
}

Face FaceOf(const Mesh& mesh, Index element, int side)
{
  const int* corners = mesh.Corners == 8 ? HexFaces[side] : TetFaces[side];
  Face face;
  for (int c = 0; c < 4; ++c)
  {
    face[c] = corners[c] < 0 ? -1 : mesh.Elements[mesh.Corners * element + corners[c]];
  }
  return face;
}

/// An element and the number of its face.
struct Side
{
  Index Element;
  int Number;
};

/// The elements of every face, by its sorted points.
std::map<Face, std::vector<Side>> FacesOf(const Mesh& mesh)
{
  std::map<Face, std::vector<Side>> faces;
  for (Index element = 0; element < static_cast<Index>(mesh.ElementIds.size()); ++element)
  {
    for (int number = 0; number < CountFaces(mesh); ++number)
    {
      Face face = FaceOf(mesh, element, number);
      std::sort(face.begin(), face.end());
      faces[face].push_back({ element, number });
    }
  }
  return faces;
}

/// The faces of a closed surface, over their edges and points.
class Surface
{
public:
  /// corners: of a face.
  Surface(const std::vector<Face>& faces, int corners) : Faces(faces), Corners(corners)
  {
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      for (int c = 0; c < corners; ++c)
      {
        this->Edges[this->EdgeOf(f, c)].push_back(f);
        this->Fans[faces[f][c]].push_back(f);
      }
    }
  }

  Index CountOddEdges() const
  {
    return std::count_if(this->Edges.begin(), this->Edges.end(),
      [](const auto& edge) { return edge.second.size() != 2; });
  }

  Index CountNonManifoldPoints() const
  {
    return std::count_if(this->Fans.begin(), this->Fans.end(),
      [this](const auto& fan) { return this->IsNonManifold(fan); });
  }

private:
  using Edge = std::pair<Index, Index>;

  Edge EdgeOf(std::size_t face, int corner) const
  {
    return std::minmax(this->Faces[face][corner], this->Faces[face][(corner + 1) % this->Corners]);
  }

  /// Whether the faces at the point are not connected over the edges at it.
  bool IsNonManifold(const std::pair<const Index, std::vector<std::size_t>>& fan) const
  {
    std::set<std::size_t> reached{ fan.second[0] };
    std::vector<std::size_t> front{ fan.second[0] };
    while (!front.empty())
    {
      const std::size_t face = front.back();
      front.pop_back();
      for (int c = 0; c < this->Corners; ++c)
      {
        const Edge edge = this->EdgeOf(face, c);
        if (edge.first != fan.first && edge.second != fan.first)
        {
          continue;
        }
        for (std::size_t other : this->Edges.at(edge))
        {
          if (reached.insert(other).second)
          {
            front.push_back(other);
          }
        }
      }
    }
    return reached.size() != fan.second.size();
  }

  const std::vector<Face>& Faces;
  int Corners;
  std::map<Edge, std::vector<std::size_t>> Edges;
  std::map<Index, std::vector<std::size_t>> Fans;
};

template <class T>
bool SameContent(const Buffer<T>& a, const Buffer<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
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
  FractionField::RowWriter row(field);
  Index3 p;
  for (p[2] = 0; p[2] < box.Upper[2]; ++p[2])
  {
    for (p[1] = 0; p[1] < box.Upper[1]; ++p[1])
    {
      p[0] = 0;
      row.Start(grid.Linear(p));
      for (; p[0] < box.Upper[0]; ++p[0])
      {
        row.AddLabel(label(p));
      }
      row.Finish();
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

std::string FindConformityProblem(const Mesh& mesh)
{
  if (!AreUnique(mesh.ElementIds) || !AreUnique(mesh.PointIds))
  {
    return "global ids are not unique";
  }
  const std::set<Index> used(mesh.Elements.begin(), mesh.Elements.end());
  if (used.size() != mesh.PointIds.size() || (used.size() && *used.begin() < 0))
  {
    return "unused points";
  }
  for (const auto& face : FacesOf(mesh))
  {
    if (face.second.size() > 2)
    {
      return "a face on more than two elements";
    }
  }
  return "";
}

std::map<int, SurfaceDefects> CountBoundaryDefects(const Mesh& mesh)
{
  std::map<int, std::vector<Face>> boundaries;
  for (const auto& face : FacesOf(mesh))
  {
    const Side& side = face.second[0];
    const int first = mesh.Material[side.Element];
    const int last = face.second.size() == 2 ? mesh.Material[face.second[1].Element] : -1;
    for (int material : { first, last })
    {
      if (first != last && material >= 0)
      {
        boundaries[material].push_back(FaceOf(mesh, side.Element, side.Number));
      }
    }
  }
  std::map<int, SurfaceDefects> defects;
  for (const auto& boundary : boundaries)
  {
    const Surface surface(boundary.second, mesh.CornersOfFacet());
    defects[boundary.first] = { surface.CountOddEdges(), surface.CountNonManifoldPoints() };
  }
  return defects;
}

std::string FindTopologyProblem(const Mesh& mesh)
{
  const std::string problem = FindConformityProblem(mesh);
  if (!problem.empty())
  {
    return problem;
  }
  for (const auto& material : CountBoundaryDefects(mesh))
  {
    const SurfaceDefects& defects = material.second;
    if (defects.OddEdges + defects.NonManifoldPoints > 0)
    {
      return "boundary of material " + std::to_string(material.first) + ": " +
        std::to_string(defects.OddEdges) + " edges not on two faces, " +
        std::to_string(defects.NonManifoldPoints) + " non-manifold points";
    }
  }
  return "";
}

std::string FindFragmentProblem(const Mesh& mesh)
{
  const std::size_t count = mesh.ElementIds.size();
  std::vector<std::vector<Index>> joined(count);
  for (const auto& face : FacesOf(mesh))
  {
    if (face.second.size() == 2)
    {
      const Index a = face.second[0].Element, b = face.second[1].Element;
      const bool sameMaterial = mesh.Material[a] == mesh.Material[b];
      if (sameMaterial != (mesh.Fragment[a] == mesh.Fragment[b]))
      {
        return sameMaterial ? "two fragments of one material share a face"
                            : "a fragment of two materials";
      }
      if (sameMaterial)
      {
        joined[a].push_back(b);
        joined[b].push_back(a);
      }
    }
  }
  std::set<int> seen;
  std::vector<bool> reached(count, false);
  for (std::size_t first = 0; first < count; ++first)
  {
    if (reached[first])
    {
      continue;
    }
    if (!seen.insert(mesh.Fragment[first]).second)
    {
      return "fragment " + std::to_string(mesh.Fragment[first]) + " is not connected by faces";
    }
    std::vector<Index> front{ static_cast<Index>(first) };
    reached[first] = true;
    while (!front.empty())
    {
      const Index at = front.back();
      front.pop_back();
      for (Index other : joined[at])
      {
        if (!reached[other])
        {
          reached[other] = true;
          front.push_back(other);
        }
      }
    }
  }
  return "";
}

std::string FindFacetProblem(const Mesh& mesh)
{
  const SurfaceFacets& surfaces = mesh.Surfaces;
  const int corners = mesh.CornersOfFacet();
  std::map<Face, std::size_t> facets;
  for (std::size_t f = 0; f < surfaces.SurfaceId.size(); ++f)
  {
    Face facet{ { -1, -1, -1, -1 } };
    std::copy_n(surfaces.Points.data() + corners * f, corners, facet.begin());
    std::sort(facet.begin(), facet.end());
    if (!facets.emplace(facet, f).second)
    {
      return "a facet twice";
    }
  }
  for (const auto& face : FacesOf(mesh))
  {
    const Index first = face.second.front().Element, last = face.second.back().Element;
    if (first != last && mesh.Fragment[first] == mesh.Fragment[last])
    {
      continue;
    }
    const auto at = facets.find(face.first);
    if (at == facets.end())
    {
      return "face " + std::to_string(last - first) + " between fragments that is no facet";
    }
    const int a = first == last ? 0 : mesh.Material[first], b = mesh.Material[last];
    const int* own = surfaces.MaterialPair.data() + 2 * at->second;
    if (own[0] != std::min(a, b) || own[1] != std::max(a, b))
    {
      return "a facet with materials that are not beside it";
    }
    facets.erase(at);
  }
  return facets.empty() ? "" : "a facet that is no face between fragments";
}

double MeasureVolume(const Mesh& mesh, int material)
{
  const double low = 0.5 - 0.5 / std::sqrt(3.0);
  double volume = 0.0;
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
  return volume;
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
  return a.Corners == b.Corners && SameContent(a.Points, b.Points) &&
    SameContent(a.PointIds, b.PointIds) && SameContent(a.Elements, b.Elements) &&
    SameContent(a.ElementIds, b.ElementIds) && SameContent(a.Material, b.Material) &&
    SameContent(a.Fragment, b.Fragment) && SameContent(a.GeometryDimension, b.GeometryDimension) &&
    SameContent(a.GeometryId, b.GeometryId) && SameContent(a.ScaledJacobian, b.ScaledJacobian) &&
    SameContent(a.Surfaces.Points, b.Surfaces.Points) &&
    SameContent(a.Surfaces.SurfaceId, b.Surfaces.SurfaceId) &&
    SameContent(a.Surfaces.MaterialPair, b.Surfaces.MaterialPair) &&
    SameContent(a.Surfaces.DomainSide, b.Surfaces.DomainSide);
}

} // namespace testing
} // namespace vfm
