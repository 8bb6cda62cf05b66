/// Data around a node of an interface.
#include "SharpFeatures/FeatureData.h"
#include "Base/Vector3.h"
#include "Labels/Labels.h"
#include "MeshChecks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Material 1 fills x < 3 and 0.3 of the next layer of 7^3 cells, material 2 the rest; a share of
/// each cell may be material 3.
struct PlaneData
{
  explicit PlaneData(const std::function<double(const Index3&)>& third) :
    Fractions(Fill(Grid, third)),
    Labels(AssignMaterials(Grid, Fractions, 0.5)),
    Found(Grid, Fractions, Labels, FindMixedNodes(Grid, Labels), 0.5, Run)
  {
  }
  static FractionField Fill(
    const CartesianGrid& grid, const std::function<double(const Index3&)>& third)
  {
    FractionField fractions(grid, 3);
    ForCells(grid.Global(),
      [&](const Index3& p)
      {
        const double first = p[0] < 3 ? 1.0 : p[0] == 3 ? 0.3 : 0.0, both = 1.0 - third(p);
        fractions.SetParts(
          grid.Linear(p), { { 1, both * first }, { 2, both * (1.0 - first) }, { 3, third(p) } });
      });
    return fractions;
  }

  Runtime Run;
  const CartesianGrid Grid = MakeUnitGrid(7);
  const FractionField Fractions;
  const LabelArray Labels;
  const Interface Found;
};

/// Adds some crossings on a plane through a point.
void AddCrossings(
  const Vector3& at, const Vector3& normal, int count, std::vector<LocalCrossing>& crossings)
{
  Vector3 u, v;
  MakeTangents(normal, u, v);
  for (int n = 0; n < count; ++n)
  {
    crossings.push_back({ at + (0.1 * n) * u + (0.1 * (n % 2)) * v, normal });
  }
}

} // namespace

/// The centres of 32 cells are within two cells of a node: 8 next to it, and 24 with one
/// coordinate 1.5 away.
TEST(FeatureData, CellsAroundANode)
{
  const PlaneData c([](const Index3& p) { return p[0] == 2 && p[1] == 3 ? 0.02 : 0.0; });
  const Index node = c.Found.Find(c.Grid.Linear({ { 3, 3, 3 } }));
  ASSERT_GE(node, 0);
  const NodeFrame frame = FrameOf(c.Found, node);
  EXPECT_EQ(frame.Position, (Index3{ { 3, 3, 3 } }));
  EXPECT_EQ(frame.Origin, (Vector3{ { 3.0, 3.0, 3.0 } }));
  EXPECT_EQ(frame.Widths, (Vector3{ { 1.0, 1.0, 1.0 } }));
  std::vector<SampleCell> cells;
  ASSERT_TRUE(GatherCells(c.Found, c.Fractions, frame, { { 1, 2 } }, InnerStencil, cells));
  // Four of them contain too much of another material: x = -0.5, y = 0.5.
  EXPECT_EQ(cells.size(), 32u - 4u);
  for (const SampleCell& cell : cells)
  {
    EXPECT_EQ(cell.Half, (Vector3{ { 0.5, 0.5, 0.5 } }));
    EXPECT_NEAR(cell.Fraction,
      cell.Centre[0] < 0.0     ? 0.0
        : cell.Centre[0] < 1.0 ? 0.7
                               : 1.0,
      1e-14);
    EXPECT_NEAR(cell.Weight, std::exp(-Dot(cell.Centre, cell.Centre) / (2.0 * 0.9 * 0.9)), 1e-14);
    EXPECT_FALSE(cell.Centre[0] == -0.5 && cell.Centre[1] == 0.5);
  }
  std::vector<SampleCell> wide;
  ASSERT_TRUE(GatherCells(c.Found, c.Fractions, frame, { { 1, 2 } }, WideStencil, wide));
  EXPECT_GT(wide.size(), cells.size());
  const std::vector<SampleCell> narrowed = Narrowed(wide, InnerStencil);
  ASSERT_EQ(narrowed.size(), cells.size());
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    EXPECT_EQ(narrowed[n].Centre, cells[n].Centre);
    EXPECT_EQ(narrowed[n].Weight, cells[n].Weight);
  }
}

TEST(FeatureData, TooFewCellsOfThePair)
{
  const PlaneData c([](const Index3& p) { return p[1] < 3 ? 0.0 : 0.4; });
  const PlaneData all([](const Index3&) { return 0.4; });
  const auto gather = [](const PlaneData& data)
  {
    const NodeFrame frame = FrameOf(data.Found, data.Found.Find(data.Grid.Linear({ { 3, 3, 3 } })));
    std::vector<SampleCell> cells;
    return GatherCells(data.Found, data.Fractions, frame, { { 1, 2 } }, InnerStencil, cells);
  };
  EXPECT_TRUE(gather(c)); // half of them
  EXPECT_FALSE(gather(all));
}

TEST(FeatureData, CrossingsAroundANode)
{
  const PlaneData c([](const Index3&) { return 0.0; });
  FaceWalk walk(c.Found);
  const Index node = c.Found.Find(c.Grid.Linear({ { 3, 3, 3 } }));
  std::vector<LocalCrossing> crossings;
  GatherCrossings(c.Found, FrameOf(c.Found, node), node, { { 1, 2 } }, walk, crossings);
  EXPECT_EQ(crossings.size(), 36u); // the faces at 5 x 5 nodes
  for (const LocalCrossing& crossing : crossings)
  {
    EXPECT_NEAR(crossing.Point[0], 0.3, 1e-12);
    EXPECT_NEAR(crossing.Normal[0], 1.0, 1e-12);
    EXPECT_LE(std::fabs(crossing.Point[1]), 2.5);
  }
  GatherCrossings(c.Found, FrameOf(c.Found, node), node, { { 0, 2 } }, walk, crossings);
  EXPECT_TRUE(crossings.empty());
}

TEST(FeatureData, PlanesOfCrossings)
{
  const Vector3 x{ { 1.0, 0.0, 0.0 } }, z{ { 0.0, 0.0, 1.0 } };
  std::vector<LocalCrossing> crossings;
  AddCrossings(0.2 * x, x, 5, crossings);
  AddCrossings(0.1 * z, z, 7, crossings);
  AddCrossings({}, Unit({ { -1.0, -1.0, -1.0 } }), 4, crossings); // too few
  const std::vector<LocalQuadric> planes = FindPlanes(crossings);
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_NEAR(Norm(planes[0].N - z), 0.0, 1e-12);
  EXPECT_NEAR(planes[0].Base[2], 0.1, 1e-12);
  EXPECT_NEAR(Norm(planes[1].N - x), 0.0, 1e-12);
  EXPECT_NEAR(planes[1].Base[0], 0.2, 1e-12);
  // If less than 35 % of the crossings are on planes, there is no edge.
  for (int n = 1; n <= 30; ++n)
  {
    crossings.push_back({ {}, { { std::cos(n), std::sin(n), 0.0 } } });
  }
  EXPECT_TRUE(FindPlanes(crossings).empty());
}
