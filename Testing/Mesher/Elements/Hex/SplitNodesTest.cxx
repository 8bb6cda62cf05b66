/// Interfaces through coarse cells.
#include "Elements/Hex/SplitNodes.h"
#include "Base/Vector3.h"
#include "Elements/Hex/HexStars.h"
#include "MeshChecks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// A grid of 4^3 base cells of 2^3 finest cells each, none of them refined.
struct CoarseCells
{
  explicit CoarseCells(const std::function<int(const Index3&)>& labelOfBase) :
    Levels(Grid, MakePlan(), {}, Run.Group()),
    Refined(MakeRefinedMesh(Levels.Families(), Levels.Base().Global(), false)),
    Labels(AssignMaterials(Grid,
      MakeLabels(Grid, 3,
        [&](const Index3& p) {
          return labelOfBase({ { p[0] / 2, p[1] / 2, p[2] / 2 } });
        }),
      0.5))
  {
  }
  static LevelPlan MakePlan()
  {
    LevelPlan plan;
    plan.Refinements = 1;
    plan.FineInterfaces = false;
    return plan;
  }
  SplitNodes Find() const
  {
    return FindSplitNodes(this->Levels, this->Refined, this->Levels.Base().Global(), this->Labels,
      [](const OctreeKeys::LevelIndex&) { return true; });
  }
  Index KeyOf(const Index3& node) const { return this->Levels.Lattice().NodeKey(0, node, 0); }

  Runtime Run;
  const CartesianGrid Grid = MakeUnitGrid(8);
  const RefinedGrid Levels;
  const RefinedMesh Refined;
  const LabelArray Labels;
};

int TwoHalves(const Index3& cell)
{
  return cell[0] < 2 ? 1 : 2;
}

} // namespace

TEST(HexStars, AreTheCellsAtNodesOfAPlane)
{
  const CoarseCells c(TwoHalves);
  const HexStars stars(c.Levels, c.Refined, c.Levels.Base().Global(), c.Labels);
  ASSERT_EQ(stars.Nodes().size(), 25u);
  EXPECT_EQ(stars.Hexes().size(), 2u * 16u);
  EXPECT_EQ(LabelOfLeaf(c.Levels, c.Labels, { 0, { { 1, 3, 0 } }, 0 }), 1);
  for (Index n = 0; n < 25; ++n)
  {
    const Index3 node = c.Levels.Lattice().NodeOfKey(stars.Nodes()[n]).At;
    EXPECT_EQ(node[0], 2);
    EXPECT_EQ(stars.Find(c.KeyOf(node)), n);
    EXPECT_EQ(stars.DomainSides(n), c.Levels.Base().DomainSides(node));
    const HexStars::Star star = stars.StarOf(n);
    std::size_t cells = 2;
    for (int a : { 1, 2 })
    {
      cells *= node[a] == 0 || node[a] == 4 ? 1 : 2;
    }
    EXPECT_EQ(star.size(), cells);
    for (const HexStars::Corner& corner : star)
    {
      const HexStars::Hex& hex = stars.Hexes()[corner.Hex];
      EXPECT_EQ(corner.Node, n);
      EXPECT_EQ(hex.What, HexStars::Kind::Base);
      EXPECT_EQ(hex.Place.Label, TwoHalves(hex.Place.Cell.At));
      EXPECT_EQ(CornerOfCell(hex.Place.Cell.At, corner.Bits), node);
      EXPECT_EQ(stars.KeyAt(hex, corner.Bits), stars.Nodes()[n]);
      EXPECT_EQ(stars.PointAt(hex, corner.Bits), c.Levels.Base().NodePoint(node));
    }
    EXPECT_EQ(stars.WidthsAt(star), (Vector3{ { 2.0, 2.0, 2.0 } }));
  }
  EXPECT_EQ(stars.Find(c.KeyOf({ { 1, 1, 1 } })), -1);
}

TEST(SplitNodes, OfAPlane)
{
  const CoarseCells c(TwoHalves);
  const SplitNodes nodes = c.Find();
  ASSERT_EQ(nodes.Count(), 25);
  for (Index n = 0; n < 25; ++n)
  {
    const Index3 node = c.Levels.Lattice().NodeOfKey(nodes.Keys[n]).At;
    const Vector3 x = c.Levels.Base().NodePoint(node);
    EXPECT_EQ(nodes.Find(nodes.Keys[n]), n);
    ASSERT_EQ(
      std::vector<int>(nodes.LabelsBegin(n), nodes.LabelsEnd(n)), (std::vector<int>{ 1, 2 }));
    EXPECT_EQ(nodes.CountInner(n), 2);
    EXPECT_EQ(nodes.NumberOfInner(n, 2), 1);
    for (int rank : { 0, 1 })
    {
      EXPECT_TRUE(nodes.HasInner(n, rank));
      const Vector3 way = nodes.InnerPoint(n, rank) - x;
      EXPECT_GT(rank == 0 ? -way[0] : way[0], 0.1);
      EXPECT_LT(std::fabs(way[0]), 1.0); // less than half of a cell
      for (int a : { 1, 2 })
      {
        EXPECT_NEAR(way[a], 0.0, 1e-12);
      }
    }
  }
  ASSERT_EQ(nodes.Faces.size(), 16u);
  for (const SplitNodes::InterfaceQuad& face : nodes.Faces)
  {
    std::array<Vector3, 4> x;
    std::transform(face.Nodes.begin(), face.Nodes.end(), x.begin(),
      [&](Index n)
      { return c.Levels.Base().NodePoint(c.Levels.Lattice().NodeOfKey(nodes.Keys[n]).At); });
    EXPECT_EQ(Cross(x[2] - x[0], x[3] - x[1]), (Vector3{ { 8.0, 0.0, 0.0 } })); // twice the area
    EXPECT_EQ(face.Sides[0].Label, 1);
    EXPECT_EQ(face.Sides[1].Label, 2);
    EXPECT_EQ(face.Sides[0].Cell.At[0], 1);
    EXPECT_EQ(face.Sides[1].Cell.At[0], 2);
  }
  EXPECT_EQ(nodes.HexFaces.size(), 32u);
  const auto facesOf = [&](const Index3& cell)
  { return nodes.FacesOfHex(c.Levels.Lattice().HexKey(0, cell, 0)); };
  EXPECT_EQ(facesOf({ { 1, 0, 3 } }), 1 << 1);
  EXPECT_EQ(facesOf({ { 2, 3, 1 } }), 1 << 0);
  EXPECT_EQ(facesOf({ { 0, 0, 0 } }), 0);
  for (const std::vector<Index>& families : nodes.BadFamilies)
  {
    EXPECT_TRUE(families.empty());
  }
}

/// Three labels at one edge: their inner points are on their own sides.
TEST(SplitNodes, OfAJunction)
{
  const auto labelOf = [](const Index3& p) { return p[0] < 2 ? 1 : p[1] < 2 ? 2 : 3; };
  const CoarseCells c(labelOf);
  const SplitNodes nodes = c.Find();
  const Index n = nodes.Find(c.KeyOf({ { 2, 2, 1 } }));
  ASSERT_GE(n, 0);
  EXPECT_EQ(nodes.CountInner(n), 3);
  EXPECT_EQ(nodes.RankOf(n, 3), 2);
  const Vector3 x{ { 4.0, 4.0, 2.0 } };
  const Vector3 first = nodes.InnerPoint(n, 0) - x, second = nodes.InnerPoint(n, 1) - x,
                third = nodes.InnerPoint(n, 2) - x;
  EXPECT_LT(first[0], 0.0);
  EXPECT_TRUE(second[0] > 0.0 && second[1] < 0.0);
  EXPECT_TRUE(third[0] > 0.0 && third[1] > 0.0);
}

/// Where two cells of a label touch along an edge, no direction sees all faces: their families
/// are to be refined.
TEST(SplitNodes, CellsThatTouchAtAnEdgeAreRefined)
{
  const CoarseCells c(
    [](const Index3& p) { return p[2] == 1 && p[0] == p[1] && (p[0] == 1 || p[0] == 2) ? 2 : 1; });
  const SplitNodes nodes = c.Find();
  ASSERT_FALSE(nodes.BadFamilies.empty());
  EXPECT_FALSE(nodes.BadFamilies[0].empty());
}
