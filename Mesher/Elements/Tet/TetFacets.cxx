#include "Elements/Tet/TetFacets.h"

#include "Elements/EqualFaces.h"
#include "Elements/GridCoordinates.h"
#include "Elements/TetQuality.h"
#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

/// Returns the points of a face of a tet, with the normal out of it.
/// @param face  4 * tet + opposite corner
std::array<Index, 3> PointsOf(const Mesh& mesh, Index face)
{
  const Index* tet = mesh.Elements.data() + face / 4 * 4;
  const int* corners = FaceOfTet[face % 4];
  return { { tet[corners[0]], tet[corners[1]], tet[corners[2]] } };
}

/// Calls visit(same) for the faces with the same points (ForEqualFaces); NumberedFace::Number is
/// the position in a list.
template <class Visit>
void ForEqualTetFaces(const Mesh& mesh, const std::vector<Index>& faces, const Visit& visit)
{
  const auto pointsOf = [&](Index f)
  {
    const std::array<Index, 3> points = PointsOf(mesh, faces[f]);
    FaceIds sorted{ { -1, points[0], points[1], points[2] } };
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  ForEqualFaces(faces.size(), pointsOf, visit);
}

/// Lists the faces without points inside a material, except those of the barrier. Only these can be
/// on interfaces or the domain boundary.
/// @return 4 * tet + opposite corner, ascending
std::vector<Index> ListFaces(
  const Mesh& mesh, const std::vector<PointPosition>& positions, const BarrierElements& barrier)
{
  std::vector<Index> faces;
  const Index count = static_cast<Index>(mesh.ElementIds.size());
  for (Index t = 0; t < count; ++t)
  {
    if (barrier.Contain(mesh, t))
    {
      continue;
    }
    const Index* tet = mesh.Elements.data() + 4 * t;
    int inside = 0;
    for (int c = 0; c < 4; ++c)
    {
      inside += positions[tet[c]] == PointPosition::Inside;
    }
    for (int c = 0; inside <= 1 && c < 4; ++c)
    {
      if (inside == 1 && positions[tet[c]] != PointPosition::Inside)
      {
        continue;
      }
      faces.push_back(4 * t + c);
    }
  }
  return faces;
}

/// Returns the side of the domain on which all points of a face are, or -1.
int DomainSideOf(const Mesh& mesh, const CartesianGrid& grid, const std::array<Index, 3>& points)
{
  int sides = 63;
  for (Index p : points)
  {
    sides &= FindDomainSides(grid, mesh.Points.data() + 3 * p);
  }
  for (int side = 0; side < 6; ++side)
  {
    if (sides >> side & 1)
    {
      return side;
    }
  }
  return -1;
}

} // namespace

TetFaces FindTetFaces(const Mesh& mesh, const std::vector<PointPosition>& positions,
  const BarrierElements& barrier, const CartesianGrid& grid)
{
  const std::vector<Index> listed = ListFaces(mesh, positions, barrier);
  TetFaces faces;
  ForEqualTetFaces(mesh, listed,
    [&](std::span<const NumberedFace> same)
    {
      const bool isAlone = same.size() == 1;
      Index inner = listed[same.front().Number], outer = listed[same.back().Number];
      const int materials[] = { mesh.Material[inner / 4], mesh.Material[outer / 4] };
      if (!isAlone && materials[0] == materials[1])
      {
        faces.Joined.push_back({ { inner / 4, outer / 4 } });
        return;
      }
      if (materials[0] < materials[1])
      {
        std::swap(inner, outer);
      }
      const std::array<Index, 3> points = PointsOf(mesh, inner);
      faces.Faces.push_back({ points, inner / 4, isAlone ? -1 : outer / 4,
        isAlone ? DomainSideOf(mesh, grid, points) : -1 });
    });
  return faces;
}

std::vector<Facet> ListFacets(
  const TetFaces& faces, const CartesianGrid& grid, const Partition& partition, const Mesh& mesh)
{
  std::vector<Facet> facets;
  facets.reserve(faces.Faces.size());
  for (const TetFace& face : faces.Faces)
  {
    const bool isAlone = face.Outer < 0;
    const Index writer = isAlone ? face.Inner : std::min(face.Inner, face.Outer);
    facets.push_back({ { { face.Points[0], face.Points[1], face.Points[2], face.Points[2] } },
      { { mesh.Material[face.Inner], isAlone ? 0 : mesh.Material[face.Outer] } },
      { { mesh.Fragment[face.Inner], isAlone ? 0 : mesh.Fragment[face.Outer] } }, face.DomainSide,
      partition.OwnsCell(CellOfElement(grid, mesh, mesh.ElementIds[writer])) });
  }
  return facets;
}

std::vector<Facet> JoinTriangles(
  const std::vector<Facet>& facets, const TetFaces& faces, const Mesh& mesh)
{
  std::vector<std::pair<Index, std::size_t>> order; // face of the grid and facet
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    order.emplace_back((mesh.ElementIds[faces.Faces[f].Inner] - 1) / (4 * PiecesPerTet), f);
  }
  std::sort(order.begin(), order.end());
  std::vector<Facet> quads;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    Facet quad = facets[order[i].second];
    const bool isCoarse = IsCoarseTet(
      *mesh.Levels, mesh.ElementIds[faces.Faces[order[i].second].Inner], TetIds.ElementSlots);
    if (!isCoarse && i + 1 < order.size() && order[i + 1].first == order[i].first)
    {
      const std::array<Index, 4>& other = facets[order[++i].second].Points;
      const auto isIn = [](const std::array<Index, 4>& points, Index p)
      { return std::find(points.begin(), points.end(), p) != points.end(); };
      const Index far =
        *std::find_if(other.begin(), other.end(), [&](Index p) { return !isIn(quad.Points, p); });
      const auto own = std::find_if(
        quad.Points.begin(), quad.Points.begin() + 3, [&](Index p) { return !isIn(other, p); });
      std::rotate(quad.Points.begin(), own, quad.Points.begin() + 3);
      quad.Points = { { quad.Points[0], quad.Points[1], far, quad.Points[2] } };
    }
    quads.push_back(quad);
  }
  return quads;
}

std::vector<std::array<Index, 3>> FindBoundary(const Mesh& mesh, const std::vector<Index>& tets)
{
  std::vector<Index> listed;
  for (Index t : tets)
  {
    for (int c = 0; c < 4; ++c)
    {
      listed.push_back(4 * t + c);
    }
  }
  std::vector<std::array<Index, 3>> faces;
  ForEqualTetFaces(mesh, listed,
    [&](std::span<const NumberedFace> same)
    {
      if (same.size() == 1)
      {
        faces.push_back(PointsOf(mesh, listed[same[0].Number]));
      }
    });
  return faces;
}

} // namespace vfm
