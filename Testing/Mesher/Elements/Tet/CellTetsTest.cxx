/// Tets of cells, their faces, and where the boundary of a material touches itself.
#include "Elements/Tet/CellTets.h"
#include "Base/Vector3.h"
#include "Elements/Tet/NonManifoldNodes.h"
#include "Elements/Tet/TetFacets.h"
#include "Elements/Tet/TetTopology.h"
#include "MeshChecks.h"
#include "NoCoarseTets.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Tets of labels, with the faces between materials.
struct LabelTets
{
  LabelTets(Index nx, Index n, const std::function<int(const Index3&)>& label) :
    Grid(MakeUnitGrid(nx, n, n)),
    Parts(Grid, Run.Group()),
    Fractions(MakeLabels(Grid, 2, label)),
    Labels(AssignMaterials(Grid, Fractions, 0.5)),
    Topology(BuildCellTets(Labels, false, NarrowVoid(), Run, NoCoarseTets(Grid, Run).Tets)),
    Faces(FindTetFaces(Topology.Tets, Topology.Positions, Topology.Barrier, Grid))
  {
  }
  Vector3 At(Index point) const { return this->Topology.Tets.PointAt(point); }
  Index IdOf(const Index3& vertex) const { return this->Grid.NodeKey(vertex) * 64 + 1; }
  std::vector<Index> FindNonManifold() const
  {
    return FindNonManifoldNodes(this->Topology, this->Faces, this->Grid, this->Parts);
  }

  Runtime Run;
  const CartesianGrid Grid;
  const Partition Parts;
  const FractionField Fractions;
  const LabelArray Labels;
  TetTopology Topology;
  const TetFaces Faces;
};

int TwoHalves(const Index3& cell)
{
  return cell[0] < 2 ? 1 : 2;
}

} // namespace

/// Four cells of two materials along x, 3 x 3 across.
TEST(CellTets, FillTheirCells)
{
  const LabelTets c(4, 3, TwoHalves);
  const Mesh& mesh = c.Topology.Tets;
  double volumes[3] = {};
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    const Index* p = mesh.Elements.data() + 4 * t;
    const Vector3 a = c.At(p[0]);
    const double volume = Dot(Cross(c.At(p[1]) - a, c.At(p[2]) - a), c.At(p[3]) - a) / 6.0;
    EXPECT_NEAR(volume, 1.0 / 12.0, 1e-15); // half of a sixth of a cell, or two quarters
    volumes[mesh.Material[t]] += volume;
    for (const Index* n = p; n != p + 4; ++n)
    {
      EXPECT_TRUE(mesh.Material[t] == 1 ? c.At(*n)[0] <= 2.0 : c.At(*n)[0] >= 2.0);
    }
  }
  EXPECT_NEAR(volumes[1], 18.0, 1e-12);
  EXPECT_NEAR(volumes[2], 18.0, 1e-12);
  ASSERT_EQ(mesh.PointIds.size(), 36u + 5u * 4 * 4);
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    const Vector3 x = c.At(static_cast<Index>(p));
    const bool isCentre = x[0] != std::floor(x[0]);
    EXPECT_EQ(IsCentre(mesh, mesh.PointIds[p]), isCentre);
    const bool isOnSide =
      x[0] == 0.0 || x[0] == 4.0 || x[1] == 0.0 || x[1] == 3.0 || x[2] == 0.0 || x[2] == 3.0;
    EXPECT_EQ(c.Topology.Positions[p],
      x[0] == 2.0  ? PointPosition::OnInterface
        : isOnSide ? PointPosition::OnDomain
                   : PointPosition::Inside);
    if (isCentre)
    {
      const Index3 cell = CellOfCentre(c.Grid, mesh, mesh.PointIds[p]);
      EXPECT_EQ(x, c.Grid.NodePoint(cell) + (Vector3{ { 0.5, 0.5, 0.5 } }));
    }
  }
}

TEST(TetFacets, OfTwoMaterials)
{
  LabelTets c(4, 3, TwoHalves);
  Mesh& mesh = c.Topology.Tets;
  const std::size_t quads = 9 + 2 * (12 + 12 + 9);
  ASSERT_EQ(c.Faces.Faces.size(), 2 * quads);
  Vector3 sums[7] = {}; // of area vectors, on the interface and sides
  for (const TetFace& face : c.Faces.Faces)
  {
    const auto& p = face.Points;
    const Vector3 normal = 0.5 * Cross(c.At(p[1]) - c.At(p[0]), c.At(p[2]) - c.At(p[0]));
    EXPECT_NEAR(Norm(normal), 0.5, 1e-15);
    sums[face.DomainSide + 1] = sums[face.DomainSide + 1] + normal;
    EXPECT_EQ(face.Outer >= 0, face.DomainSide < 0);
    EXPECT_TRUE(
      face.Outer < 0 || (mesh.Material[face.Inner] == 2 && mesh.Material[face.Outer] == 1));
  }
  EXPECT_EQ(sums[0], (Vector3{ { -9.0, 0.0, 0.0 } })); // out of material 2
  for (int side = 0; side < 6; ++side)
  {
    Vector3 right{};
    right[side / 2] = (side % 2 ? 1.0 : -1.0) * (side / 2 == 0 ? 9.0 : 12.0);
    EXPECT_EQ(sums[side + 1], right);
  }
  mesh.Fragment = Buffer<int>(mesh.Material.size());
  std::copy(mesh.Material.begin(), mesh.Material.end(), mesh.Fragment.begin());
  const std::vector<Facet> facets = ListFacets(c.Faces, c.Grid, c.Parts, mesh);
  const std::vector<Facet> joined = JoinTriangles(facets, c.Faces, mesh);
  ASSERT_EQ(joined.size(), quads);
  for (const Facet& quad : joined)
  {
    const auto& p = quad.Points;
    const Vector3 twice = Cross(c.At(p[2]) - c.At(p[0]), c.At(p[3]) - c.At(p[1]));
    EXPECT_NEAR(Norm(twice), 2.0, 1e-14);
    EXPECT_EQ(twice[0] < 0.0, quad.DomainSide == 0 || quad.DomainSide == -1);
    EXPECT_TRUE(quad.IsOwned);
    EXPECT_EQ(quad.Materials[1], quad.DomainSide < 0 ? 1 : 0);
  }
}

TEST(TetFacets, BoundaryOfSomeTetsIsClosed)
{
  const LabelTets c(4, 3, TwoHalves);
  std::vector<Index> tets;
  for (std::size_t t = 0; t < c.Topology.Tets.Material.size(); ++t)
  {
    if (c.Topology.Tets.Material[t] == 2)
    {
      tets.push_back(static_cast<Index>(t));
    }
  }
  double volume = 0.0;
  const auto boundary = FindBoundary(c.Topology.Tets, tets);
  EXPECT_EQ(boundary.size(), 2u * 2u * (6 + 6 + 9));
  for (const std::array<Index, 3>& p : boundary)
  {
    volume += Dot(Cross(c.At(p[0]), c.At(p[1])), c.At(p[2])) / 6.0;
  }
  EXPECT_NEAR(volume, 18.0, 1e-12);
}

/// Two cells in void that share a node, an edge or a face.
TEST(NonManifoldNodes, WhereCellsTouch)
{
  const auto find = [](const Index3& other) {
    return [other](const Index3& p) { return p == Index3{ { 1, 1, 1 } } || p == other ? 1 : 0; };
  };
  const LabelTets node(4, 4, find({ { 2, 2, 2 } }));
  EXPECT_EQ(node.FindNonManifold(), (std::vector<Index>{ node.IdOf({ { 2, 2, 2 } }) }));
  const LabelTets edge(4, 4, find({ { 2, 2, 1 } }));
  EXPECT_EQ(edge.FindNonManifold(),
    (std::vector<Index>{ edge.IdOf({ { 2, 2, 1 } }), edge.IdOf({ { 2, 2, 2 } }) }));
  EXPECT_TRUE(LabelTets(4, 4, find({ { 2, 1, 1 } })).FindNonManifold().empty());
}
