/// Labels of lattice nodes.
#include "Elements/Tet/LatticeNodes.h"
#include "MeshChecks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// 5^3 cells. Material 1 fills x < 2 and a share of the cells of layer 2; material 2 the rest.
struct TwoLayers
{
  explicit TwoLayers(double share) :
    Parts(Grid, Run.Group()),
    Fractions(Fill(Grid, share)),
    Labels(AssignMaterials(Grid, Fractions, 0.5)),
    Nodes(Grid, Fractions, Labels, 0.5, Parts, Run)
  {
  }
  static FractionField Fill(const CartesianGrid& grid, double share)
  {
    FractionField fractions = MakeLabels(grid, 2, [](const Index3& p) { return p[0] < 2 ? 1 : 2; });
    for (Index n = 0; share > 0.0 && n < 25; ++n)
    {
      fractions.SetParts(
        grid.Linear({ { 2, n % 5, n / 5 } }), { { 1, share }, { 2, 1.0 - share } });
    }
    return fractions;
  }
  int LabelOf(LatticeNodes::Kind kind, const Index3& p) const
  {
    return this->Nodes.Labels(kind)[this->Grid.Linear(p)];
  }

  Runtime Run;
  const CartesianGrid Grid = MakeUnitGrid(5);
  const Partition Parts;
  const FractionField Fractions;
  const LabelArray Labels;
  LatticeNodes Nodes;
};

bool IsInside(const Index3& p, Index low, Index high)
{
  return p[1] > low && p[1] < high && p[2] > low && p[2] < high;
}

} // namespace

/// The interface is in the nodes of the plane x = 2, so all of them are snapped, and no centre is.
TEST(LatticeNodes, OnAnInterfaceAreSnapped)
{
  const TwoLayers c(0.0);
  EXPECT_EQ(c.Nodes.MixedVertices().size(), 36u);
  ForCells({ {}, { { 6, 6, 6 } } },
    [&](const Index3& p)
    {
      const int label = p[0] < 2 ? 1 : 2;
      EXPECT_EQ(c.LabelOf(LatticeNodes::Vertex, p), p[0] == 2 ? LatticeNodes::Snapped : label);
      if (c.Grid.InDomain(p))
      {
        EXPECT_EQ(c.LabelOf(LatticeNodes::Centre, p), label);
      }
    });
}

/// With 0.4 of material 1 in the layer at x = 2 to 3, the difference of fractions is -0.4 at the
/// vertices of x = 2, 0.2 at the centres of the layer and 0.6 at x = 3. So the interface is at 1/3
/// of the edges from these centres to the vertices, which snaps the centres, and at 40 % of the
/// edges between the vertices, which does not snap them.
TEST(LatticeNodes, NearAnInterfaceAreSnapped)
{
  TwoLayers c(0.4);
  ForCells({ {}, { { 6, 6, 6 } } },
    [&](const Index3& p)
    {
      const int vertex =
        p[0] == 2 ? (IsInside(p, 0, 5) ? 1 : LatticeNodes::Snapped) : (p[0] < 2 ? 1 : 2);
      EXPECT_EQ(c.LabelOf(LatticeNodes::Vertex, p), vertex) << TextOf(p);
      if (c.Grid.InDomain(p))
      {
        const bool isSnapped = p[0] == 2 && IsInside(p, 0, 4);
        EXPECT_EQ(c.LabelOf(LatticeNodes::Centre, p),
          isSnapped    ? LatticeNodes::Snapped
            : p[0] < 2 ? 1
                       : 2)
          << TextOf(p);
      }
    });
  EXPECT_DOUBLE_EQ(c.Nodes.OwnFraction(c.Grid.Linear({ { 2, 2, 2 } })), 0.6);
}

TEST(LatticeNodes, SettledNodesAreAsInCells)
{
  TwoLayers c(0.4);
  const LatticeNodes::Node centre{ LatticeNodes::Centre, { { 2, 2, 2 } } };
  const LatticeNodes::Node vertex{ LatticeNodes::Vertex, { { 2, 3, 3 } } };
  EXPECT_EQ(c.Nodes.IdOf(centre), c.Grid.NodeKey({ { 2, 2, 2 } }) * 64 + 2);
  const std::vector<Index> ids{ c.Nodes.IdOf(centre), c.Nodes.IdOf(vertex) };
  EXPECT_TRUE(c.Nodes.Settle(ids, c.Parts));
  EXPECT_EQ(c.LabelOf(LatticeNodes::Centre, centre.Position), 2);
  EXPECT_EQ(c.LabelOf(LatticeNodes::Vertex, vertex.Position), LatticeNodes::Snapped);
  EXPECT_EQ(c.LabelOf(LatticeNodes::Centre, { { 2, 2, 1 } }), LatticeNodes::Snapped);
  EXPECT_FALSE(c.Nodes.Settle(ids, c.Parts));
}
