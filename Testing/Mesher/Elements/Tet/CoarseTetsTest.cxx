/// Tets outside the finest cells: a graded body-centred lattice.
#include "Elements/Tet/CoarseTets.h"
#include "Base/Vector3.h"
#include "Elements/EqualFaces.h"
#include "Elements/Tet/CellTets.h"
#include "Elements/Tet/LeafNodes.h"
#include "Elements/TetQuality.h"
#include "MeshChecks.h"
#include "Octree/LevelIds.h"
#include "Sweep.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns random cells of every level.
LevelPlan MakePlan(const CartesianGrid& finest, int refinements, double chance, unsigned seed)
{
  LevelPlan plan;
  plan.Refinements = refinements;
  plan.Unit = RefinedUnit::Cell;
  std::mt19937 random(seed);
  for (int level = 0; level < refinements; ++level)
  {
    const Index cells = finest.Global().NumberOfCells() >> 3 * (refinements - level);
    plan.Families.emplace_back();
    for (Index key = 0; key < cells; ++key)
    {
      if (random() < chance * 4294967296.0)
      {
        plan.Families.back().push_back(key);
      }
    }
  }
  return plan;
}

/// All tets of a grid of one label.
struct GradedTets
{
  GradedTets(const CartesianGrid& grid, const LevelPlan& plan) :
    Levels(std::make_shared<const RefinedGrid>(grid, plan, std::vector<Index>(), Run.Group())),
    Labels(AssignMaterials(grid, MakeLabels(grid, 1, [](const Index3&) { return 1; }), 0.5)),
    Coarse(*Levels, Labels, false, NarrowVoid(), Run.Group()),
    Topology(BuildCellTets(Labels, false, NarrowVoid(), Run, Coarse))
  {
  }

  Runtime Run;
  std::shared_ptr<const RefinedGrid> Levels;
  const LabelArray Labels;
  const CoarseTets Coarse;
  TetTopology Topology;
};

double VolumeOf(const Mesh& mesh, std::size_t tet)
{
  const Vector3 x = mesh.PointAt(mesh.Elements[4 * tet]);
  const auto edge = [&](int c) { return mesh.PointAt(mesh.Elements[4 * tet + c]) - x; };
  return Dot(edge(1), Cross(edge(2), edge(3))) / 6.0;
}

/// Returns the smallest and the largest dihedral angle.
std::array<double, 2> AngleRange(const Mesh& mesh)
{
  std::array<double, 2> range{ { 180.0, 0.0 } };
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    double angles[6];
    DihedralAngles(mesh.Points.data(), mesh.Elements.data() + 4 * t, angles);
    range[0] = std::min(range[0], *std::min_element(angles, angles + 6));
    range[1] = std::max(range[1], *std::max_element(angles, angles + 6));
  }
  return range;
}

/// Returns the numbers of faces of no other tet that are on a side of the domain, and that are not.
std::array<Index, 2> CountSingleFaces(const Mesh& mesh, const CartesianGrid& grid)
{
  std::array<Index, 2> counts{};
  const auto pointsOf = [&](Index f)
  {
    FaceIds points{ { -1, -1, -1, -1 } };
    for (int c = 0; c < 3; ++c)
    {
      points[c + 1] = mesh.Elements[f / 4 * 4 + FaceOfTet[f % 4][c]];
    }
    std::sort(points.begin(), points.end());
    return points;
  };
  ForEqualFaces(4 * mesh.ElementIds.size(), pointsOf,
    [&](std::span<const NumberedFace> same)
    {
      EXPECT_LE(same.size(), 2u);
      int sides = same.size() == 1 ? 63 : 0;
      for (int c = 1; same.size() == 1 && c < 4; ++c)
      {
        const Vector3 x = mesh.PointAt(same[0].Points[c]);
        for (int a = 0; a < 3; ++a)
        {
          sides &= ~(x[a] != grid.Coordinates(a).front() ? 1 << 2 * a : 0);
          sides &= ~(x[a] != grid.Coordinates(a).back() ? 2 << 2 * a : 0);
        }
      }
      counts[0] += sides != 0;
      counts[1] += same.size() == 1 && sides == 0;
    });
  return counts;
}

} // namespace

TEST(CoarseTets, FillTheDomain)
{
  for (unsigned seed : ListSeeds(24))
  {
    const int refinements = 1 + static_cast<int>(seed % 3);
    const Index base = refinements == 1 ? 6 : refinements == 2 ? 4 : 2;
    const CartesianGrid grid =
      MakeUnitGrid(base << refinements, (base + 1) << refinements, base << refinements);
    const GradedTets c(grid, MakePlan(grid, refinements, 0.02 * (1 + seed % 7), seed));
    const Mesh& mesh = c.Topology.Tets;
    SCOPED_TRACE(seed);
    double volume = 0.0;
    for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
    {
      const double own = VolumeOf(mesh, t);
      EXPECT_GT(own, 0.0);
      volume += own;
    }
    const double box = static_cast<double>(grid.Global().NumberOfCells());
    EXPECT_NEAR(volume, box, 1e-9 * box);
    const std::array<Index, 2> single = CountSingleFaces(mesh, grid);
    EXPECT_GT(single[0], 0);
    EXPECT_EQ(single[1], 0);
    const std::array<double, 2> angles = AngleRange(mesh);
    EXPECT_GT(angles[0], 45.0 - 1e-9);
    EXPECT_LT(angles[1], 120.0 + 1e-9);
    EXPECT_TRUE(std::is_sorted(mesh.PointIds.begin(), mesh.PointIds.end()));
    EXPECT_EQ(
      std::set<Index>(mesh.PointIds.begin(), mesh.PointIds.end()).size(), mesh.PointIds.size());
    EXPECT_TRUE(std::is_sorted(mesh.ElementIds.begin(), mesh.ElementIds.end()));
    EXPECT_EQ(std::set<Index>(mesh.ElementIds.begin(), mesh.ElementIds.end()).size(),
      mesh.ElementIds.size());
  }
}

/// Each tet lies in the cells of the centres that it has, and its id leads to one of them.
TEST(CoarseTets, BelongToTheCellsOfTheirCentres)
{
  const CartesianGrid grid = MakeUnitGrid(16);
  const GradedTets c(grid, MakePlan(grid, 2, 0.1, 3));
  const Mesh& mesh = c.Topology.Tets;
  Index coarse = 0;
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    const IndexBox cells = CellsOfElement(grid, mesh, mesh.ElementIds[t]);
    coarse += cells.Size(0) > 1;
    bool found = false;
    for (int corner = 0; corner < 4; ++corner)
    {
      const Index point = mesh.Elements[4 * t + corner];
      const Vector3 x = mesh.PointAt(point);
      bool isMiddle = IsCentre(mesh, mesh.PointIds[point]);
      for (int a = 0; a < 3; ++a)
      {
        isMiddle = isMiddle && x[a] == 0.5 * static_cast<double>(cells.Lower[a] + cells.Upper[a]);
      }
      found = found || isMiddle;
    }
    ASSERT_TRUE(found) << t;
  }
  EXPECT_GT(coarse, 0);
}

/// Points of finest cells that are not known as near a distant vertex share tets only with points
/// next to them, which have other colours.
TEST(LeafNodes, FindsVerticesOfOneColourInATet)
{
  Index near = 0, moves = 0;
  for (unsigned seed : ListSeeds(12))
  {
    const int refinements = 2 + static_cast<int>(seed % 2);
    const CartesianGrid grid = MakeUnitGrid(16, 8, 24);
    const GradedTets c(grid, MakePlan(grid, refinements, 0.01 * (1 + seed % 5), seed));
    const Mesh& mesh = c.Topology.Tets;
    const auto isVertex = [&](Index point)
    {
      const Index id = mesh.PointIds[point];
      return !IsCoarsePoint(*c.Levels, id, TetIds.PointSlots) && SlotOfPoint(id) == VertexSlot;
    };
    for (std::size_t at = 0; at < mesh.Elements.size(); ++at)
    {
      const Index point = mesh.Elements[at];
      if (!isVertex(point))
      {
        continue;
      }
      const Index3 node = NodeOfPoint(grid, mesh, mesh.PointIds[point]);
      ASSERT_TRUE(IsFineVertex(*c.Levels, node));
      const bool isNear = IsNearDistantVertex(*c.Levels, node);
      ASSERT_FALSE(isNear && c.Levels->IsFineAround(node));
      near += isNear;
      moves += !isNear && !c.Levels->IsFineAround(node);
      for (std::size_t other = at / 4 * 4; !isNear && other < at / 4 * 4 + 4; ++other)
      {
        const Index end = mesh.Elements[other];
        if (end != point && isVertex(end))
        {
          const Index3 far = NodeOfPoint(grid, mesh, mesh.PointIds[end]);
          ASSERT_NE(grid.Colour(node), grid.Colour(far)) << TextOf(node) << TextOf(far);
        }
      }
    }
  }
  EXPECT_GT(near, 0);
  EXPECT_GT(moves, 0);
}

TEST(LeafNodes, FindMidpoints)
{
  const CartesianGrid grid = MakeUnitGrid(8);
  LevelPlan plan;
  plan.Refinements = 1;
  plan.Unit = RefinedUnit::Cell;
  plan.Families = { { 0 } }; // the lowest of 4^3 cells
  const GradedTets c(grid, plan);
  EXPECT_TRUE(IsRefined(*c.Levels, { 0, { { 0, 0, 0 } }, 0 }));
  EXPECT_FALSE(IsRefined(*c.Levels, { 0, { { 1, 0, 0 } }, 0 }));
  EXPECT_FALSE(IsRefined(*c.Levels, { 0, { { -1, 0, 0 } }, 0 }));
  const auto count = [&](const Index3& cell)
  {
    int halved = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      for (int a = 0; a < 3; ++a)
      {
        halved += HasMidpoint(*c.Levels, { 0, cell, 0 }, corner, corner ^ 1 << a);
      }
    }
    return halved / 2; // each edge was counted at both ends
  };
  EXPECT_EQ(count({ { 1, 0, 0 } }), 4);
  EXPECT_EQ(count({ { 1, 1, 0 } }), 1);
  EXPECT_EQ(count({ { 1, 1, 1 } }), 0);
  EXPECT_EQ(count({ { 2, 0, 0 } }), 0);
}

TEST(CoarseTets, OneRefinedCellCostsLittle)
{
  const CartesianGrid grid = MakeUnitGrid(16);
  LevelPlan plan;
  plan.Refinements = 1;
  plan.Unit = RefinedUnit::Cell;
  plan.Families = { {} };
  const GradedTets plain(grid, plan);
  plan.Families = { { 3 + 8 * (3 + 8 * 3) } };
  const GradedTets one(grid, plan);
  EXPECT_EQ(plain.Topology.Tets.ElementIds.size(), 12u * 512u);
  // The 12 faces between the eight children have 4 tets. Each face of the cell had 4; it has 8 on
  // the coarse side and 2 for each of its four parts. At each of its 12 edges, two tets between the
  // cells around are halved.
  EXPECT_EQ(
    one.Topology.Tets.ElementIds.size(), 12u * 512u + 12 * 4 + 6 * (8 + 4 * 2 - 4) + 12 * 2);
  EXPECT_EQ(one.Levels->Families().Report(0).Requested, 1);
}
