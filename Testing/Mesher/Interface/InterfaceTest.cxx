/// Interfaces of two materials whose exact fractions are known.
#include "Interface/Interface.h"
#include "Base/Vector3.h"
#include "Fractions/LayerFit.h"
#include "Interface/Crossings.h"
#include "Labels/Labels.h"
#include "MeshChecks.h"
#include "RandomDraw.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Fills a half-space with material 1 and the rest with material 2.
FractionField FillHalfSpace(const CartesianGrid& grid, const Layer& layer)
{
  FractionField fractions(grid, 2);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      const Vector3 low = grid.NodePoint(p), high = grid.NodePoint(CornerOfCell(p, 7));
      const double f = FractionInLayer(layer, 0.5 * (low + high), high - low);
      if (f <= 0.0 || f >= 1.0)
      {
        fractions.SetLabel(grid.Linear(p), f > 0.0 ? 1 : 2);
        return;
      }
      fractions.SetParts(grid.Linear(p), { { 1, f }, { 2, 1.0 - f } });
    });
  return fractions;
}

struct HalfSpace
{
  HalfSpace(CartesianGrid grid, const Layer& layer, const std::vector<Index>& steps = {}) :
    Grid(std::move(grid)),
    Fractions(FillHalfSpace(Grid, layer)),
    Labels(AssignMaterials(Grid, Fractions, 0.5)),
    Found(Grid, Fractions, Labels, FindMixedNodes(Grid, Labels), 0.5, Run, steps)
  {
  }

  Runtime Run;
  const CartesianGrid Grid;
  const FractionField Fractions;
  const LabelArray Labels;
  const Interface Found;
};

} // namespace

/// The plane x = 2.3 in unit cells: cells of layer 2 contain 0.3 of material 1.
TEST(Interface, OfAPlaneAlongTheGridIsExact)
{
  const HalfSpace c(MakeUnitGrid(5, 4, 3), { { { 1, 0, 0 } }, -INFINITY, 2.3 });
  ASSERT_EQ(c.Found.Faces().size(), 4u * 3u);
  ASSERT_EQ(c.Found.Nodes().size(), 5u * 4u);
  EXPECT_EQ(c.Found.Scale(), 1.0);
  for (std::size_t f = 0; f < c.Found.Faces().size(); ++f)
  {
    const InterfaceFace& face = c.Found.Faces()[f];
    EXPECT_EQ(face.Axis, 0);
    EXPECT_EQ(face.LowerLabel, 1);
    EXPECT_EQ(face.UpperLabel, 2);
    const Index3 node = c.Grid.Position(face.Node);
    EXPECT_EQ(node[0], 2);
    const Crossing& crossing = c.Found.Crossings()[f];
    const Vector3 point{ { 2.3, static_cast<double>(node[1]) + 0.5,
      static_cast<double>(node[2]) + 0.5 } };
    EXPECT_NEAR(Norm(crossing.Point - point), 0.0, 1e-12);
    EXPECT_NEAR(crossing.Normal[0], 1.0, 1e-12);
    EXPECT_EQ(crossing.Weight, 1.0);
    for (int n = 0; n < 4; ++n)
    {
      const Index corner = c.Found.Nodes()[c.Found.CornersOfFace(static_cast<Index>(f))[n]];
      EXPECT_EQ(corner, NodesOfFace(c.Grid, face)[n]);
    }
  }
  for (std::size_t n = 0; n < c.Found.Nodes().size(); ++n)
  {
    const Index i = static_cast<Index>(n), node = c.Found.Nodes()[n];
    EXPECT_EQ(c.Found.Find(node), i);
    ASSERT_EQ(c.Found.PointOffset(i), i);
    const SurfacePoint& point = c.Found.Points()[n];
    EXPECT_EQ(c.Found.FindPoint(i, 1, 2), &point);
    EXPECT_EQ(c.Found.FindPoint(i, 0, 2), nullptr);
    const Vector3 x = c.Found.NodePoint(node);
    EXPECT_NEAR(Norm(point.Point - (x + (Vector3{ { 0.3, 0.0, 0.0 } }))), 0.0, 1e-12);
    EXPECT_NEAR(point.Normal[0], 1.0, 1e-12);
    const bool isEdge = (x[1] == 0.0 || x[1] == 4.0) + (x[2] == 0.0 || x[2] == 3.0) == 2;
    const bool isInner = x[1] > 0.0 && x[1] < 4.0 && x[2] > 0.0 && x[2] < 3.0;
    EXPECT_EQ(c.Found.FaceOffset(i + 1) - c.Found.FaceOffset(i), isInner ? 4 : isEdge ? 1 : 2);
  }
  EXPECT_EQ(c.Found.Find(c.Grid.Linear({ { 1, 1, 1 } })), -1);
}

/// Gradients over 3^3 cells are close to those of planes; in cells at a side they are tilted.
TEST(Interface, ObliquePlanesAreFound)
{
  RandomDraw random(7);
  for (int i = 0; i < 10; ++i)
  {
    const Vector3 normal = Unit(random.Vector(-1, 1)), middle{ { 4.0, 4.0, 4.0 } };
    const double at = Dot(normal, middle) + random.Between(-0.5, 0.5);
    const HalfSpace c(MakeUnitGrid(8), { normal, -INFINITY, at });
    const auto isInner = [](const Vector3& x)
    { return std::all_of(x.begin(), x.end(), [](double at) { return at > 1.5 && at < 6.5; }); };
    for (const Crossing& crossing : c.Found.Crossings())
    {
      if (!isInner(crossing.Point))
      {
        continue;
      }
      EXPECT_NEAR(Dot(normal, crossing.Point), at, 0.02);
      EXPECT_GT(Dot(normal, crossing.Normal), 0.99);
    }
    for (const SurfacePoint& point : c.Found.Points())
    {
      if (!isInner(point.Point))
      {
        continue;
      }
      EXPECT_NEAR(Dot(normal, point.Point), at, 0.02);
      EXPECT_GT(Dot(normal, point.Normal), 0.99);
    }
  }
}

/// Widths at a node are means of the cells inside, in mean cells.
TEST(Interface, NodeWidths)
{
  const CartesianGrid grid = MakeUnevenGrid(4);
  const HalfSpace c(grid, { { { 1, 0, 0 } }, -INFINITY, grid.Coordinates(0)[2] });
  const Vector3 widths = c.Found.NodeWidths(grid.Linear({ { 2, 0, 4 } }));
  const double unit = grid.MeanWidth();
  EXPECT_NEAR(widths[0], 0.5 * (grid.Width(0, 1) + grid.Width(0, 2)) / unit, 1e-14);
  EXPECT_NEAR(widths[1], grid.Width(1, 0) / unit, 1e-14);
  EXPECT_NEAR(widths[2], grid.Width(2, 3) / unit, 1e-14);
}

/// The label of a cell may differ from its fractions. Then its faces have the crossing of the
/// nearest face whose cells have their labels by fractions.
TEST(Crossings, NearStepsAreThoseOfTheInterface)
{
  const HalfSpace c(MakeUnitGrid(7, 7, 7), { { { 1, 0, 0 } }, -INFINITY, 3.3 });
  // The face between cells 3 and 4, as if cell 3 had label 1; the interface is one face lower.
  const InterfaceFace face{ c.Grid.Linear({ { 4, 3, 3 } }), 0, 1, 2 };
  CrossingFinder finder(c.Grid, c.Fractions, 0.5);
  const Crossing near = finder.FindNear(face);
  EXPECT_NEAR(Norm(near.Point - (Vector3{ { 3.3, 3.5, 3.5 } })), 0.0, 1e-12);
  EXPECT_NEAR(near.Normal[0], 1.0, 1e-12);
  const InterfaceFace own{ c.Grid.Linear({ { 3, 3, 3 } }), 0, 1, 2 };
  const Crossing crossing = finder.Find(own);
  EXPECT_EQ(finder.FindNear(own).Point, crossing.Point);
}

/// A finder that has found the crossings of other faces returns those of a new one.
TEST(Crossings, DoNotDependOnThoseBefore)
{
  const CartesianGrid grid = MakeUnevenGrid(17);
  const FractionField fractions = MakePatchyFractions(grid, 5, 3);
  CrossingFinder finder(grid, fractions, 0.5);
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      for (int axis = 0; axis < 3 && p[axis] > 0; ++axis)
      {
        const Index node = grid.Linear(p);
        const InterfaceFace face{ node, axis,
          MaterialOfCell(fractions, node - grid.Stride(axis), 0.5),
          MaterialOfCell(fractions, node, 0.5) };
        if (face.LowerLabel != face.UpperLabel)
        {
          const Crossing found = finder.Find(face);
          const Crossing alone = CrossingFinder(grid, fractions, 0.5).Find(face);
          ASSERT_EQ(found.Point, alone.Point);
          ASSERT_EQ(found.Normal, alone.Normal);
          ASSERT_EQ(found.Weight, alone.Weight);
        }
      }
    });
}

/// Other iso values and pure cells interpolate: D = 2 (1 - vf_0 - isoValue) is 2 * 0.75 and
/// 2 * -0.25 at the centres x = 2.5 and 3.5, so the interface is at three quarters.
TEST(Crossings, OfVoidWithAnIsoValue)
{
  const CartesianGrid grid = MakeUnitGrid(6, 3, 3);
  const FractionField fractions =
    MakeLabels(grid, 1, [](const Index3& p) { return p[0] < 3 ? 1 : 0; });
  const InterfaceFace face{ grid.Linear({ { 3, 1, 1 } }), 0, 1, 0 };
  const Crossing crossing = CrossingFinder(grid, fractions, 0.25).Find(face);
  EXPECT_NEAR(crossing.Point[0], 2.5 + 0.75, 1e-12);
  EXPECT_NEAR(crossing.Normal[0], -1.0, 1e-12); // from void to material 1
}
