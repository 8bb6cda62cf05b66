/// Interfaces and targets on the grids of several levels: near the true surface, and
/// the same on parts of the grid.
#include "RankFields.h"
#include "RankMeshes.h"
#include "ThreadRanks.h"

#include "Base/Vector3.h"
#include "Fractions/CoarsenFields.h"
#include "Interface/LevelInterfaces.h"
#include "Interface/SurfaceTargets.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Cells = 96; // cells of the finest grid along each axis
constexpr double Radius = 33.0;
const Vector3 Centre{ { 48.3, 48.1, 47.8 } };

/// Returns the families in the half x < middle; the box of each refinement
/// is smaller than the one before.
LevelPlan HalfPlan(const CartesianGrid& grid, int refinements)
{
  LevelPlan plan;
  plan.Refinements = refinements;
  plan.FineInterfaces = false;
  const CartesianGrid base = CoarsenGrid(grid, refinements, 0);
  const OctreeKeys lattice(base, refinements);
  for (int level = 0; level < refinements; ++level)
  {
    IndexBox families;
    for (int a = 0; a < 3; ++a)
    {
      families.Upper[a] = grid.Global().Upper[a] >> (refinements - level + 1);
    }
    families.Upper[0] = families.Upper[0] * (refinements - level) / (refinements + 1);
    plan.Families.emplace_back();
    ForCells(families,
      [&](const Index3& q) { plan.Families.back().push_back(lattice.FamilyKey(level, q)); });
  }
  return plan;
}

/// Labels each leaf by the fractions of its level.
LabelArray MakeBlockyLabels(
  const RefinedGrid& levels, const FractionField& fractions, Runtime& runtime)
{
  const CartesianGrid& grid = levels.Finest();
  const int refinements = levels.NumberOfRefinements();
  LabelArray labels = AssignMaterials(grid, fractions, 0.5);
  for (int level = 0; level < refinements; ++level)
  {
    const int halvings = refinements - level;
    const CartesianGrid coarse =
      CoarsenGrid(grid, halvings, CountCoarseGhosts(grid, halvings, GhostLayers));
    const FractionField means = CoarsenFractions(grid, fractions, halvings, coarse, runtime);
    const LabelArray own = AssignMaterials(coarse, means, 0.5);
    ForCells(grid.Local(),
      [&](const Index3& cell)
      {
        const OctreeKeys::LevelIndex leaf = levels.LeafOf(cell);
        if (leaf.Level == level && coarse.Local().Contains(leaf.At))
        {
          labels.Set(grid.Linear(cell), own[coarse.Linear(leaf.At)]);
        }
      });
  }
  return labels;
}

/// A sphere on levels, on the whole grid or the part of a rank.
struct LevelCase
{
  LevelCase(const CartesianGrid& grid, const FractionField& fractions, const LevelPlan& plan,
    SurfaceTargets::Kind kind, Runtime& runtime) :
    Levels(grid, plan, {}, runtime.Group()),
    Labels(MakeBlockyLabels(Levels, fractions, runtime)),
    Interfaces(Levels, fractions, Labels, FindMixedNodes(Levels.Finest(), Labels), 0.5, runtime),
    Targets(Interfaces.All(), kind, runtime)
  {
  }
  /// Returns whether a leaf of the level inside a box of finest cells has the node as a corner.
  bool IsAtLeaf(int level, const Index3& node, const IndexBox& box) const
  {
    for (int c = 0; c < 8; ++c)
    {
      const Index3 cell = CornerOfCell({ { node[0] - 1, node[1] - 1, node[2] - 1 } }, c);
      const Index3 lowest = this->Levels.FinestCells(level, cell).Lower;
      if (box.Contains(lowest) && this->Levels.LeafOf(lowest).Level == level)
      {
        return true;
      }
    }
    return false;
  }

  RefinedGrid Levels;
  LabelArray Labels;
  LevelInterfaces Interfaces;
  SurfaceTargets Targets;
};

FractionField SphereFractions(const CartesianGrid& grid)
{
  return FractionsOfShapes(grid, { MakeSphere(1, Centre, Radius) });
}

} // namespace

TEST(CoarsenFields, MeansOfTheCells)
{
  Runtime runtime;
  const CartesianGrid grid = MakeUnevenGrid(24);
  const FractionField fractions = MakePatchyFractions(grid, 3, 1);
  for (int halvings = 1; halvings <= 3; ++halvings)
  {
    const CartesianGrid coarse = CoarsenGrid(grid, halvings, 0);
    const FractionField means = CoarsenFractions(grid, fractions, halvings, coarse, runtime);
    const Index factor = Index(1) << halvings;
    ForCells(coarse.Local(),
      [&](const Index3& cell)
      {
        for (int m = 0; m <= 3; ++m)
        {
          double sum = 0.0;
          IndexBox box;
          for (int a = 0; a < 3; ++a)
          {
            box.Lower[a] = cell[a] * factor;
            box.Upper[a] = box.Lower[a] + factor;
          }
          ForCells(box,
            [&](const Index3& p)
            { sum += fractions.Fraction(grid.Linear(p), m) * grid.CellVolume(p); });
          ASSERT_NEAR(means.Fraction(coarse.Linear(cell), m), sum / coarse.CellVolume(cell), 1e-13);
        }
      });
  }
}

class LevelTargets : public ::testing::TestWithParam<std::tuple<int, SurfaceTargets::Kind>>
{
};

TEST_P(LevelTargets, LieOnTheSphere)
{
  const int refinements = std::get<0>(this->GetParam());
  const CartesianGrid grid = MakeUnitGrid(Cells);
  Runtime runtime;
  const LevelCase levels(grid, SphereFractions(grid), HalfPlan(grid, refinements),
    std::get<1>(this->GetParam()), runtime);
  Index first = 0;
  for (int level = 0; level <= refinements; ++level)
  {
    const Interface& interface = levels.Interfaces.Of(level);
    const double scale = interface.Scale();
    double largest = 0.0, squares = 0.0, tilt = 1.0, farthest = 0.0;
    Index count = 0;
    for (Index n = 0; n < static_cast<Index>(interface.Nodes().size()); ++n)
    {
      const Index3 node = interface.Grid().Position(interface.Nodes()[n]);
      for (Index p = interface.PointOffset(n);
           levels.IsAtLeaf(level, node, grid.Global()) && p < interface.PointOffset(n + 1); ++p)
      {
        const Vector3 away = scale * interface.Points()[p].Point - Centre;
        const Vector3 x = Centre + (Radius / Norm(away)) * away; // nearest point on the sphere
        const double distance = (Norm(away) - Radius) / scale;
        Vector3 gradient;
        const double d = levels.Targets.Distance(first + p, x, gradient);
        // The point lies half a cell outside, in the void; normals point
        // from there into the sphere.
        const Vector3 outside = x + (.5 * scale / Norm(away)) * away;
        EXPECT_NEAR(levels.Targets.Distance(first + p, outside, gradient), -.5, .06);
        EXPECT_EQ(levels.Interfaces.FindTarget(level, node, { { 0, 1 } }), first + p);
        largest = std::max(largest, std::fabs(d));
        farthest = std::max(farthest, std::fabs(distance));
        squares += d * d;
        tilt = std::min(tilt, -Dot(Unit(gradient), Unit(away)));
        ++count;
      }
    }
    std::printf("level %d: %lld points, %zu nodes: distance of targets from the sphere %.4f "
                "largest, %.4f rms, "
                "of surface points %.4f cells; smallest cosine of normals %.4f\n",
      level, static_cast<long long>(count), interface.Nodes().size(), largest,
      std::sqrt(squares / count), farthest, tilt);
    EXPECT_GT(count, 100);
    EXPECT_LT(largest, .05);
    EXPECT_GT(tilt, .98);
    first += static_cast<Index>(interface.Points().size());
  }
  EXPECT_EQ(first, levels.Targets.Count());
}

INSTANTIATE_TEST_SUITE_P(Refinements, LevelTargets,
  ::testing::Combine(::testing::Values(1, 2),
    ::testing::Values(SurfaceTargets::Kind::Quadrics, SurfaceTargets::Kind::Facets)));

TEST(LevelInterfaces, FindsTheNearestTarget)
{
  const CartesianGrid grid = MakeUnitGrid(48);
  Runtime runtime;
  const LevelCase levels(grid, FractionsOfShapes(grid, { MakeSphere(1, { { 24, 24, 24 } }, 16.0) }),
    HalfPlan(grid, 1), SurfaceTargets::Kind::Quadrics, runtime);
  const Interface& interface = levels.Interfaces.Of(0);
  int tried = 0;
  for (Index at : interface.Nodes())
  {
    Index3 p = interface.Grid().Position(at);
    p[0] += 1;
    if (interface.Find(interface.Grid().Linear(p)) >= 0)
    {
      continue;
    }
    ++tried;
    const Index target = levels.Interfaces.FindTarget(0, p, { { 0, 1 } });
    ASSERT_GE(target, 0);
    Index nearest = 100, own = 100; // squares
    for (Index n = 0; n < static_cast<Index>(interface.Nodes().size()); ++n)
    {
      const Index3 q = interface.Grid().Position(interface.Nodes()[n]);
      Index square = 0;
      for (int a = 0; a < 3; ++a)
      {
        square += (q[a] - p[a]) * (q[a] - p[a]);
      }
      const bool has = interface.FindPoint(n, 0, 1) != nullptr;
      nearest = has ? std::min(nearest, square) : nearest;
      own = has && interface.PointOffset(n) == target ? square : own;
    }
    EXPECT_EQ(own, nearest);
  }
  EXPECT_GT(tried, 10);
  EXPECT_EQ(levels.Interfaces.FindTarget(0, { { 12, 12, 12 } }, { { 0, 1 } }), -1);
  EXPECT_EQ(
    levels.Interfaces.FindTarget(0, interface.Grid().Position(interface.Nodes()[0]), { { 0, 2 } }),
    -1);
}

/// Compares gradients with finite differences. Distances are in cells of the level, so a step of
/// one finest cell changes a coarser level's distance by less.
TEST(LevelDistances, GradientsFitTheDistances)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  Runtime runtime;
  const LevelCase levels(
    grid, SphereFractions(grid), HalfPlan(grid, 2), SurfaceTargets::Kind::Quadrics, runtime);
  const double step = 1e-5;
  Index first = 0;
  for (int level = 0; level <= 2; ++level)
  {
    const Interface& interface = levels.Interfaces.Of(level);
    const double scale = interface.Scale(); // the finest cells are unit cubes
    for (Index p = 0; p < static_cast<Index>(interface.Points().size()); p += 7)
    {
      const Vector3 x = scale *
        (interface.Points()[p].Point +
          Vector3{ { .03, -.06, .02 + .03 * static_cast<double>(p % 3) } });
      Vector3 gradient, unused;
      levels.Targets.Distance(first + p, x, gradient);
      for (int a = 0; a < 3; ++a)
      {
        Vector3 low = x, high = x;
        low[a] -= step;
        high[a] += step;
        // The gradient neglects the change of the quadric's slope.
        EXPECT_NEAR((levels.Targets.Distance(first + p, high, unused) -
                      levels.Targets.Distance(first + p, low, unused)) /
            (2.0 * step) * scale,
          gradient[a] * scale, .01);
      }
      EXPECT_NEAR(Norm(gradient) * scale, 1.0, 1e-12);
      EXPECT_NEAR(levels.Targets.LocalScale(first + p) * scale, 1.0, 1e-12);
    }
    first += static_cast<Index>(interface.Points().size());
  }
}

class LevelParts : public ::testing::TestWithParam<SurfaceTargets::Kind>
{
};

/// Compares the targets of a rank, at nodes of its own leaves, with those of the whole grid.
void ExpectSameTargets(const LevelCase& part, const LevelCase& whole, const IndexBox& owned)
{
  const int refinements = whole.Levels.NumberOfRefinements();
  for (int level = 0; level <= refinements; ++level)
  {
    Index found = 0;
    for (Index node : whole.Interfaces.Of(level).Nodes())
    {
      const Index3 p = whole.Interfaces.Of(level).Grid().Position(node);
      if (!whole.IsAtLeaf(level, p, owned))
      {
        continue;
      }
      const Index a = whole.Interfaces.FindTarget(level, p, { { 0, 1 } });
      const Index b = part.Interfaces.FindTarget(level, p, { { 0, 1 } });
      ASSERT_GE(a, 0);
      ASSERT_GE(b, 0);
      const Vector3 x =
        whole.Interfaces.Of(refinements).Grid().NodePoint(whole.Levels.FinestNode(level, p));
      Vector3 gradientA, gradientB;
      EXPECT_EQ(whole.Targets.Distance(a, x, gradientA), part.Targets.Distance(b, x, gradientB));
      EXPECT_EQ(gradientA, gradientB);
      EXPECT_EQ(whole.Targets.LocalScale(a), part.Targets.LocalScale(b));
      ++found;
    }
    EXPECT_GT(found, 50);
  }
}

TEST_P(LevelParts, SameAsOfTheWhole)
{
  const int refinements = 2;
  const CartesianGrid grid = MakeUnitGrid(Cells);
  const FractionField fractions = SphereFractions(grid);
  const LevelPlan plan = HalfPlan(grid, refinements);
  Runtime serial;
  const LevelCase whole(grid, fractions, plan, this->GetParam(), serial);
  // The boxes cross borders of levels.
  const std::vector<IndexBox> boxes = CutBaseBox(grid, refinements, 3, 1);
  RunOnRanks(3,
    [&](Ranks& ranks)
    {
      const IndexBox& box = boxes[ranks.Rank()];
      const CartesianGrid local(grid, box, GhostLayers << refinements);
      EXPECT_LT(local.Local().NumberOfCells(), grid.Local().NumberOfCells());
      RankRuntime runtime(ranks);
      const LevelCase part(
        local, CopyToLocal(grid, fractions, local), plan, this->GetParam(), runtime);
      ExpectSameTargets(part, whole, box);
    });
}

INSTANTIATE_TEST_SUITE_P(Kinds, LevelParts,
  ::testing::Values(SurfaceTargets::Kind::Quadrics, SurfaceTargets::Kind::Facets));
