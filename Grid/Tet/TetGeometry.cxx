#include "Tet/TetGeometry.h"

namespace vfm
{

void FindTetGeometry(const TetFaces& faces, const CartesianGrid& grid, const Partition& partition,
  Mesh& mesh, MeshReport& report)
{
  mesh.GeometryDimension = Buffer<int>(mesh.PointIds.size(), 3);
  mesh.GeometryId = Buffer<int>(mesh.PointIds.size());
  for (std::size_t at = 0; at < mesh.Elements.size(); ++at)
  {
    mesh.GeometryId[mesh.Elements[at]] = mesh.Fragment[at / 4]; // enough for points inside
  }
  const auto owns = [&](Index tet)
  { return partition.OwnsCell(CellOfElement(grid, mesh, mesh.ElementIds[tet])); };
  std::vector<Facet> facets;
  for (const TetFacet& face : faces.Facets)
  {
    const int inner = mesh.Fragment[face.Inner];
    const int outer = face.Outer >= 0 ? mesh.Fragment[face.Outer]
                                      : (face.DomainSide >= 0 ? -1 - face.DomainSide : 0);
    const Index writer = face.Outer < 0 ? face.Inner : std::min(face.Inner, face.Outer);
    Facet facet;
    facet.Points = { { face.Points[0], face.Points[1], face.Points[2], -1 } };
    facet.Sides = { { std::min(inner, outer), std::max(inner, outer) } };
    facet.Materials = { { face.Outer < 0 ? 0 : mesh.Material[face.Outer],
      mesh.Material[face.Inner] } };
    facet.DomainSide = face.DomainSide;
    facet.IsOwned = owns(writer);
    facets.push_back(facet);
  }
  ClassifyGeometry(facets, grid, partition, mesh, report);
}

} // namespace vfm
