/// Targets and edges from given surfaces, and whole meshes with them.
#include "GivenSurfaces/FollowSurfaces.h"
#include "GivenCases.h"

#include "Elements/MeshRun.h"
#include "MeshChecks.h"
#include "Phases/MeshOfCells.h"
#include "RankMeshes.h"
#include "SharpFeatures/FeaturePlaces.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const Vector3 Centre{ { 9.2, 9.1, 9.3 } };

ClosedSurface TurnedBox(double half, const Vector3& centre = Centre)
{
  const Vector3 edge{ { half, half, 0.7 * half } };
  return Turned(BoxSurface(centre - edge, centre + edge), centre, { { 20, 30, 40 } });
}

double LargestDistance(const GivenCase& given, const SurfaceTargets& targets, double radius)
{
  double largest = 0.0;
  for (std::size_t p = 0; p < given.Surface.Points().size(); ++p)
  {
    const Vector3 outwards = Unit(given.Surface.Points()[p].Point - Centre);
    Vector3 gradient;
    const double distance =
      targets.Distance(static_cast<Index>(p), Centre + radius * outwards, gradient);
    largest = std::max(largest, std::fabs(distance));
  }
  return largest;
}

TEST(FollowSurfaces, TargetsLieOnTheSurface)
{
  GivenCase sphere(18, { SphereSurface(Centre, 5.0, 96) });
  SurfaceTargets targets(sphere.Surface, SurfaceTargets::Kind::Quadrics, sphere.Run);
  EXPECT_GT(LargestDistance(sphere, targets, 5.0), 0.01);
  const SharpFeatures features =
    FollowSurfaces(sphere.Surfaces, { &sphere.Surface }, true, sphere.Run, targets);
  EXPECT_LT(LargestDistance(sphere, targets, 5.0), 0.008);
  EXPECT_TRUE(features.IsEmpty());
}

/// The body of which the second label is inside, and the one of which it is outside.
TEST(FollowSurfaces, EdgesAreThoseOfTheFirstBody)
{
  const std::vector<ClosedSurface> around{ TurnedBox(4.0),
    BoxSurface({ { 1, 1, 1 } }, { { 17, 17, 17 } }) };
  for (const std::vector<ClosedSurface>& bodies :
    { std::vector<ClosedSurface>{ around[0] }, around })
  {
    GivenCase box(18, bodies);
    SurfaceTargets targets(box.Surface, SurfaceTargets::Kind::Quadrics, box.Run);
    const SharpFeatures features =
      FollowSurfaces(box.Surfaces, { &box.Surface }, true, box.Run, targets);
    int inner = 0, found = 0;
    for (std::size_t p = 0; p < box.Surface.Points().size(); ++p)
    {
      const SurfacePoint& point = box.Surface.Points()[p];
      if (point.First == (bodies.size() == 1 ? 0 : 1))
      {
        ++inner;
        const NodeFeature* feature = features.Find(static_cast<Index>(p));
        found += feature != nullptr && FindEdge(feature->Model, {}).has_value();
      }
    }
    EXPECT_GT(inner, 200);
    EXPECT_GT(found, inner / 2);
    SurfaceTargets smooth(box.Surface, SurfaceTargets::Kind::Quadrics, box.Run);
    EXPECT_TRUE(FollowSurfaces(box.Surfaces, { &box.Surface }, false, box.Run, smooth).IsEmpty());
  }
}

TEST(FollowSurfaces, PairsWithoutASurfaceKeepTheirTargets)
{
  GivenCase box(18, { TurnedBox(4.0) });
  const BodySurfaces none(box.Bodies, { "other" }, box.Grid, 40.0);
  SurfaceTargets targets(box.Surface, SurfaceTargets::Kind::Quadrics, box.Run);
  const SurfaceTargets before = targets;
  EXPECT_TRUE(FollowSurfaces(none, { &box.Surface }, true, box.Run, targets).IsEmpty());
  for (Index t = 0; t < targets.Count(); ++t)
  {
    Vector3 a, b;
    EXPECT_EQ(targets.Distance(t, Centre, a), before.Distance(t, Centre, b));
  }
}

// Makers of whole meshes have no argument for surfaces.
const InputSurfaces* TheBodies = nullptr;

Mesh MakeGiven(ElementKind elements, const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  const BodySurfaces surfaces(
    *TheBodies, GivenCase::Names(TheBodies->Bodies.size()), grid, options.EdgeAngle);
  return MakeMeshOfCells(elements, { grid, fractions, options, &surfaces }, runtime, report);
}

Mesh MakeGivenHexes(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  return MakeGiven(ElementKind::Hexes, grid, fractions, options, runtime, report);
}

Mesh MakeGivenTets(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  return MakeGiven(ElementKind::Tets, grid, fractions, options, runtime, report);
}

MeshOptions WithEdges()
{
  MeshOptions options;
  options.SharpEdges = SharpEdgeMode::Automatic;
  return options;
}

class GivenMeshes : public ::testing::Test
{
protected:
  GivenMeshes() :
    Bodies(MakeBodies({ TurnedBox(4.0), BoxSurface({ { 2, 2, 2 } }, { { 16.3, 16, 9 } }) })),
    Grid(GivenCase::Coordinates(20)),
    Fractions(FractionsOfBodies(Grid, Bodies))
  {
    TheBodies = &this->Bodies;
  }
  ~GivenMeshes() override { TheBodies = nullptr; }

  const InputSurfaces Bodies;
  const CartesianGrid Grid;
  const FractionField Fractions;
};

TEST_F(GivenMeshes, RanksMakeTheSameMesh)
{
  for (const MeshMaker make : { MakeGivenHexes, MakeGivenTets })
  {
    CompareWithSerial(this->Grid, this->Fractions,
      { CutBox(this->Grid.Global(), 2), CutBox(this->Grid.Global(), 3) }, WithEdges(), make);
  }
}

TEST_F(GivenMeshes, RanksMakeTheSameRefinedMesh)
{
  MeshOptions options = WithEdges();
  options.Levels.Refinements = 1;
  options.Levels.FineInterfaces = false;
  options.Levels.Families = RefineBelow(this->Grid, 1, 0.5);
  CompareWithSerial(
    this->Grid, this->Fractions, { CutBaseBox(this->Grid, 1, 2) }, options, MakeGivenHexes);
}

TEST_F(GivenMeshes, TheOrderOfTrianglesDoesNotMatter)
{
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = MakeGivenHexes(this->Grid, this->Fractions, WithEdges(), runtime, report);
  InputSurfaces permuted;
  for (const BodySurface& body : this->Bodies.Bodies)
  {
    std::vector<PointTriangle> triangles(
      body.Boundary.Triangles.rbegin(), body.Boundary.Triangles.rend());
    for (PointTriangle& t : triangles)
    {
      std::rotate(t.begin(), t.begin() + 1, t.end());
    }
    permuted.Bodies.push_back(MakeBody(body.Name, body.Boundary.Points, triangles));
  }
  TheBodies = &permuted;
  const Mesh other = MakeGivenHexes(
    this->Grid, FractionsOfBodies(this->Grid, permuted), WithEdges(), runtime, report);
  EXPECT_TRUE(
    std::equal(mesh.Points.begin(), mesh.Points.end(), other.Points.begin(), other.Points.end()));
}

/// Points on coarse interfaces follow the edges as those on fine ones.
TEST_F(GivenMeshes, EdgesAreKeptOnAllLevels)
{
  const InputSurfaces box = MakeBodies({ TurnedBox(9.0, { { 20, 20, 20 } }) });
  const CartesianGrid grid(GivenCase::Coordinates(40));
  TheBodies = &box;
  MeshOptions options = WithEdges();
  options.Levels.Refinements = 1;
  options.Levels.FineInterfaces = false;
  options.Levels.Families = RefineBelow(grid, 1, 0.3);
  Runtime runtime;
  MeshReport report;
  const FractionField fractions = FractionsOfBodies(grid, box);
  const Mesh mesh = MakeGivenHexes(grid, fractions, options, runtime, report);
  EXPECT_EQ(report.CornerPoints, 8);
  EXPECT_EQ(report.NumberOfSurfaces, 6);
  EXPECT_GT(report.MinimumScaledJacobian, 0.4);
}

} // namespace
