#include "Elements/Tet/TetFacets.h"

#include "Elements/GridCoordinates.h"
#include "Elements/TetQuality.h"

namespace vfm
{
namespace
{

/// Face of one tet.
struct HalfFace
{
  std::array<Index, 3> Key; // points, ascending
  Index Tet;
  int Corner; // opposite corner of the tet
  bool operator<(const HalfFace& other) const
  {
    return this->Key != other.Key ? this->Key < other.Key : this->Tet < other.Tet;
  }
};

HalfFace MakeHalfFace(const Mesh& mesh, Index t, int corner)
{
  const Index* tet = mesh.Elements.data() + 4 * t;
  const int* face = FaceOfTet[corner];
  HalfFace half{ { { tet[face[0]], tet[face[1]], tet[face[2]] } }, t, corner };
  std::sort(half.Key.begin(), half.Key.end());
  return half;
}

/// Lists the faces without points inside a material, except those of the barrier. Only these can be
/// on interfaces or the domain boundary.
std::vector<HalfFace> ListHalfFaces(
  const Mesh& mesh, const std::vector<PointPosition>& positions, const BarrierElements& barrier)
{
  std::vector<HalfFace> faces;
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
      faces.push_back(MakeHalfFace(mesh, t, c));
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Returns the side of the domain on which all points of a face are, or -1.
int DomainSideOf(const Mesh& mesh, const CartesianGrid& grid, const HalfFace& face)
{
  int sides = 63;
  for (Index p : face.Key)
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
  const std::vector<HalfFace> halves = ListHalfFaces(mesh, positions, barrier);
  TetFaces faces;
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    const HalfFace* inner = &halves[h];
    const HalfFace* outer = nullptr;
    if (h + 1 < halves.size() && halves[h + 1].Key == inner->Key)
    {
      outer = &halves[++h];
      if (mesh.Material[inner->Tet] == mesh.Material[outer->Tet])
      {
        faces.Joined.push_back({ { inner->Tet, outer->Tet } });
        continue;
      }
      if (mesh.Material[inner->Tet] < mesh.Material[outer->Tet])
      {
        std::swap(inner, outer);
      }
    }
    const Index* tet = mesh.Elements.data() + 4 * inner->Tet;
    const int* corners = FaceOfTet[inner->Corner];
    faces.Faces.push_back({ { { tet[corners[0]], tet[corners[1]], tet[corners[2]] } }, inner->Tet,
      outer ? outer->Tet : -1, outer ? -1 : DomainSideOf(mesh, grid, *inner) });
  }
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
    if (i + 1 < order.size() && order[i + 1].first == order[i].first)
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
  std::vector<HalfFace> halves;
  for (Index t : tets)
  {
    for (int c = 0; c < 4; ++c)
    {
      halves.push_back(MakeHalfFace(mesh, t, c));
    }
  }
  std::sort(halves.begin(), halves.end());
  std::vector<std::array<Index, 3>> faces;
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    if (h + 1 < halves.size() && halves[h + 1].Key == halves[h].Key)
    {
      ++h;
      continue;
    }
    const Index* tet = mesh.Elements.data() + 4 * halves[h].Tet;
    const int* face = FaceOfTet[halves[h].Corner];
    faces.push_back({ { tet[face[0]], tet[face[1]], tet[face[2]] } });
  }
  return faces;
}

} // namespace vfm
