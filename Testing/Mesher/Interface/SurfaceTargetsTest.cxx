/// Targets are the quadrics that were given, whether or not all cells have equal widths.
#include "Interface/SurfaceTargets.h"

#include "Base/Vector3.h"
#include "Labels/Labels.h"
#include "MeshChecks.h"
#include "RandomDraw.h"
#include "RankFields.h"
#include "RankMeshes.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Cells = 12;

/// The targets of a ball.
struct Ball
{
  explicit Ball(CartesianGrid grid) :
    Grid(std::move(grid)),
    Fractions(FractionsOfShapes(Grid, { MakeSphere(1, { { 6.1, 5.9, 6.2 } }, 3.7) })),
    Labels(AssignMaterials(Grid, Fractions, 0.5)),
    Found(Grid, Fractions, Labels, FindMixedNodes(Grid, Labels), 0.5, Run),
    Targets(Found, SurfaceTargets::Kind::Quadrics, Run)
  {
  }
  /// Returns the widths of the node of a surface point.
  Vector3 WidthsAt(Index point) const
  {
    Index node = 0;
    while (this->Found.PointOffset(node + 1) <= point)
    {
      ++node;
    }
    return this->Found.NodeWidths(this->Found.Nodes()[node]);
  }

  Runtime Run;
  const CartesianGrid Grid;
  const FractionField Fractions;
  const LabelArray Labels;
  const Interface Found;
  SurfaceTargets Targets;
};

LocalQuadric DrawQuadric(RandomDraw& draw)
{
  LocalQuadric quadric =
    MakeLocalPlane(draw.Vector(-1.0, 1.0), Unit(draw.Vector(-1.0, 1.0) + Vector3{ { 0, 0, 1.5 } }));
  for (double& c : quadric.C)
  {
    c = draw.Between(-0.4, 0.4);
  }
  return quadric;
}

/// Expects that a target is a quadric in cells of some widths.
void ExpectQuadric(const SurfaceTargets& targets, Index target, const LocalQuadric& quadric,
  const Vector3& origin, const Vector3& widths)
{
  // Near the base, where quadrics are not continued as planes.
  const Vector3 y = quadric.Base + 0.3 * quadric.U - 0.2 * quadric.V + 0.1 * quadric.N;
  Vector3 gradient, expected;
  const double distance = targets.Distance(target, origin + Scaled(y, widths), gradient);
  EXPECT_NEAR(distance, DistanceTo(quadric, y, expected), 1e-12);
  EXPECT_LT(Norm(gradient - Divided(expected, widths)), 1e-12);
  EXPECT_NEAR(targets.LocalScale(target), Norm(Divided(quadric.N, widths)), 1e-12);
  const LocalQuadric back = targets.QuadricOf(target, origin, widths);
  EXPECT_EQ(back.U, quadric.U);
  EXPECT_EQ(back.V, quadric.V);
  EXPECT_EQ(back.N, quadric.N);
}

void CheckReplaced(Ball ball)
{
  RandomDraw draw(1);
  ASSERT_GT(ball.Targets.Count(), 20);
  for (Index target = 0; target < ball.Targets.Count(); ++target)
  {
    const Vector3 origin = draw.Vector(0.0, 9.0), widths = ball.WidthsAt(target);
    const LocalQuadric quadric = DrawQuadric(draw);
    ball.Targets.Replace(target, quadric, origin, widths);
    ExpectQuadric(ball.Targets, target, quadric, origin, widths);
  }
}

TEST(SurfaceTargets, AreReplacedInEqualCells)
{
  CheckReplaced(Ball(MakeUnitGrid(Cells)));
}

TEST(SurfaceTargets, AreReplacedInUnequalCells)
{
  CheckReplaced(Ball(MakeUnevenGrid(Cells)));
}

TEST(SurfaceTargets, RejectOtherWidthsInEqualCells)
{
  Ball ball(MakeUnitGrid(Cells));
  RandomDraw draw(1);
  EXPECT_THROW(
    ball.Targets.Replace(0, DrawQuadric(draw), {}, { { 1.0, 1.0, 2.0 } }), std::logic_error);
}

/// Added targets may have other widths; the others keep theirs.
TEST(SurfaceTargets, KeepTheirWidthsWhenOthersAreAdded)
{
  Ball ball(MakeUnitGrid(Cells));
  RandomDraw draw(2);
  const Vector3 ones{ { 1.0, 1.0, 1.0 } }, others{ { 1.0, 0.5, 2.0 } };
  const Vector3 place{ { 3.1, 4.2, 5.3 } };
  std::vector<double> before;
  Vector3 gradient;
  for (Index target = 0; target < ball.Targets.Count(); ++target)
  {
    before.push_back(ball.Targets.Distance(target, place, gradient));
  }
  for (const Vector3& widths : { ones, others, ones, others })
  {
    const Vector3 origin = draw.Vector(0.0, 9.0);
    const LocalQuadric quadric = DrawQuadric(draw);
    const Index target = ball.Targets.Add(quadric, origin, widths);
    EXPECT_EQ(target + 1, ball.Targets.Count());
    ExpectQuadric(ball.Targets, target, quadric, origin, widths);
  }
  for (std::size_t target = 0; target < before.size(); ++target)
  {
    EXPECT_EQ(ball.Targets.Distance(target, place, gradient), before[target]);
  }
}

} // namespace
