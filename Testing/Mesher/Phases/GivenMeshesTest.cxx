/// Whole meshes of bodies with given surfaces.
#include "../GivenSurfaces/GivenCases.h"
#include "Elements/MeshRun.h"
#include "Phases/MeshOfCells.h"
#include "RankMeshes.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

ClosedSurface TurnedBox(double half, const Vector3& centre)
{
  const Vector3 edge{ { half, half, 0.7 * half } };
  return Turned(BoxSurface(centre - edge, centre + edge), centre, { { 20, 30, 40 } });
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
    Bodies(MakeBodies(
      { TurnedBox(4.0, { { 9.2, 9.1, 9.3 } }), BoxSurface({ { 2, 2, 2 } }, { { 16.3, 16, 9 } }) })),
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
