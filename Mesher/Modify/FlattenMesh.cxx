#include "Modify/FlattenMesh.h"

#include "Base/Vector3.h"
#include "Elements/ElementFaces.h"
#include "Elements/FlatPlane.h"
#include "Elements/SelectPoints.h"
#include "Octree/RefinedGrid.h"

namespace vfm
{
namespace
{

constexpr int QuadCorners = 4, HexCornersCount = 8;

/// The lower face of each hex.
class LowerFaces
{
public:
  LowerFaces(int axis, Runtime& runtime, const Mesh& mesh) :
    TheMesh(mesh),
    Lowest(mesh.Levels->Finest().Coordinates(axis).front()),
    Axis(axis),
    Quads(QuadCorners * mesh.ElementIds.size())
  {
    ForEach(runtime, mesh.ElementIds.size(), [this](Index e) { this->Find(e); });
  }

  bool IsLower(Index point) const
  {
    return this->TheMesh.Points[3 * point + this->Axis] == this->Lowest;
  }
  const Index* Quad(Index element) const { return this->Quads.data() + QuadCorners * element; }
  Buffer<Index> Take() { return std::move(this->Quads); }
  /// Returns the edge of the quad that is in a face of the hex, or -1.
  int EdgeOf(Index element, int face) const
  {
    const FaceIds points =
      ElementFaces(HexCornersCount)
        .PointsOf(this->TheMesh.Elements.data() + HexCornersCount * element, face);
    const auto has = [&points](Index point)
    { return std::find(points.begin(), points.end(), point) != points.end(); };
    const Index* quad = this->Quad(element);
    int edge = -1, corners = 0;
    for (int c = 0; c < QuadCorners; ++c)
    {
      corners += has(quad[c]);
      edge = has(quad[c]) && has(quad[(c + 1) % QuadCorners]) ? c : edge;
    }
    return corners == 2 ? edge : -1;
  }

private:
  void Find(Index element)
  {
    const ElementFaces faces(HexCornersCount);
    for (int face = 0; face < faces.Count; ++face)
    {
      const FaceIds points =
        faces.PointsOf(this->TheMesh.Elements.data() + HexCornersCount * element, face);
      if (std::all_of(points.begin(), points.end(), [this](Index p) { return this->IsLower(p); }))
      {
        std::reverse_copy(points.begin(), points.end(), this->Quads.data() + QuadCorners * element);
      }
    }
  }

  const Mesh& TheMesh;
  double Lowest;
  int Axis;
  Buffer<Index> Quads;
};

/// Facets across the plane, with the numbers of the edges of their quads.
std::vector<MeshFacet> TakeFacets(const LowerFaces& lower, const Mesh& mesh)
{
  std::vector<MeshFacet> edges;
  for (const MeshFacet& facet : mesh.Facets)
  {
    const int edge = lower.EdgeOf(facet.Element, facet.Side);
    if (edge >= 0)
    {
      edges.push_back({ facet.Element, edge, facet.Behind, 0, facet.DomainSide });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Leaves the items of which all points are lower.
void TakeLower(const LowerFaces& lower, std::size_t width, Runtime& runtime, Buffer<Index>& points,
  Buffer<int>& ids)
{
  std::vector<Index> kept;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const Index* first = points.data() + width * i;
    if (std::all_of(first, first + width, [&](Index point) { return lower.IsLower(point); }))
    {
      kept.push_back(static_cast<Index>(i));
    }
  }
  points = Select(points, kept, runtime, static_cast<Index>(width));
  ids = Select(ids, kept, runtime);
}

/// Points on the lower side that are on no curve are inside their fragment.
void NumberInside(Mesh& mesh)
{
  for (std::size_t i = 0; i < mesh.Elements.size(); ++i)
  {
    const Index point = mesh.Elements[i];
    if (mesh.GeometryDimension[point] >= DimensionOfSurfaces)
    {
      mesh.GeometryDimension[point] = DimensionOfSurfaces;
      mesh.GeometryId[point] = mesh.Fragment[i / mesh.Corners];
    }
  }
}

// Factor of the sines of a diagonal without which a triangle would have one neighbour only: solvers
// hold all points of such a triangle at the boundary.
constexpr double NeighbourFactor = 1.1;

/// Returns the edges of each quad on the boundary of the mesh, as bits.
std::vector<unsigned char> FindBoundaryEdges(const Mesh& mesh)
{
  std::vector<unsigned char> edges(mesh.ElementIds.size(), 0);
  for (const MeshFacet& facet : mesh.Facets)
  {
    edges[facet.Element] |= (facet.Behind == NothingBehind) << facet.Side;
  }
  return edges;
}

/// Returns whether both edges at corner c or at the opposite one are on the boundary.
/// @param edges  bits of the edges of a quad there
bool IsOnBoundary(int edges, int c)
{
  const auto has = [edges](int edge) { return (edges >> edge % QuadCorners & 1) != 0; };
  return (has(c + 3) && has(c)) || (has(c + 1) && has(c + 2));
}

/// Returns whether the diagonal from corner 1 to corner 3 is better than that from 0 to 2.
/// @param edges  bits of the edges of the quad on the boundary
bool TakesSecond(const FlatPlane& plane, const Mesh& mesh, const Index* q, int edges)
{
  std::array<FlatVector, 4> quad;
  std::transform(q, q + QuadCorners, quad.begin(),
    [&](Index point) { return plane.At(mesh.Points.data() + 3 * point); });
  std::array<double, 2> sines = SinesOfDiagonals(quad);
  for (int c = 0; c < 2; ++c)
  {
    sines[c] *= IsOnBoundary(edges, c) ? NeighbourFactor : 1.0;
  }
  return sines[0] != sines[1]
    ? sines[0] < sines[1]
    : std::min(q[1], q[3]) < std::min(q[0], q[2]); // ids ascend with numbers
}

template <class T>
void Double(Buffer<T>& values)
{
  Buffer<T> twice(2 * values.size());
  for (std::size_t i = 0; i < twice.size(); ++i)
  {
    twice[i] = values[i / 2];
  }
  values = std::move(twice);
}

/// Divides quads into triangles.
void Divide(const FlatPlane& plane, Runtime& runtime, Mesh& mesh)
{
  const Index quads = static_cast<Index>(mesh.ElementIds.size());
  Buffer<Index> triangles(6 * quads);
  std::vector<unsigned char> isSecond(quads);
  const std::vector<unsigned char> boundaryEdges = FindBoundaryEdges(mesh);
  ForEach(runtime, quads,
    [&](Index e)
    {
      const Index* q = mesh.Elements.data() + QuadCorners * e;
      isSecond[e] = TakesSecond(plane, mesh, q, boundaryEdges[e]);
      const std::array<Index, 6> corners = isSecond[e]
        ? std::array<Index, 6>{ { q[0], q[1], q[3], q[1], q[2], q[3] } }
        : std::array<Index, 6>{ { q[0], q[1], q[2], q[0], q[2], q[3] } };
      std::copy(corners.begin(), corners.end(), triangles.data() + 6 * e);
    });
  // Triangle and edge of each edge of a quad, by diagonal.
  constexpr int Places[2][4][2] = { { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 1, 2 } },
    { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 2 } } };
  for (MeshFacet& facet : mesh.Facets)
  {
    const int(&place)[2] = Places[isSecond[facet.Element]][facet.Side];
    facet.Element = 2 * facet.Element + place[0];
    facet.Side = place[1];
  }
  std::sort(mesh.Facets.begin(), mesh.Facets.end());
  mesh.Elements = std::move(triangles);
  mesh.Corners = 3;
  Double(mesh.ElementIds);
  Double(mesh.Material);
  Double(mesh.Fragment);
  Double(mesh.Layer);
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    mesh.ElementIds[e] = 2 * mesh.ElementIds[e] - (e % 2 == 0);
  }
}

} // namespace

std::vector<Index> FlattenMesh(int axis, FlatElement kind, Runtime& runtime, Mesh& mesh)
{
  LowerFaces lower(axis, runtime, mesh);
  mesh.Facets = TakeFacets(lower, mesh);
  TakeLower(lower, 2, runtime, mesh.Curves.Points, mesh.Curves.CurveId);
  TakeLower(lower, 1, runtime, mesh.Vertices.Points, mesh.Vertices.VertexId);
  mesh.Surfaces = SurfaceFacets();
  mesh.Tables = GeometryTables();
  std::vector<Index> kept, numbers(mesh.PointIds.size(), -1);
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    if (lower.IsLower(static_cast<Index>(p)))
    {
      numbers[p] = static_cast<Index>(kept.size());
      kept.push_back(static_cast<Index>(p));
    }
  }
  mesh.Elements = lower.Take();
  mesh.Corners = QuadCorners;
  mesh.ScaledJacobian = Buffer<float>();
  SelectPoints(kept, numbers, runtime, mesh);
  if (!mesh.PeriodicPartner.empty())
  {
    mesh.PeriodicPartner = Select(mesh.PeriodicPartner, kept, runtime);
  }
  NumberInside(mesh);
  if (kind == FlatElement::Triangle)
  {
    Divide(FlatPlane(axis), runtime, mesh);
  }
  return kept;
}

} // namespace vfm
