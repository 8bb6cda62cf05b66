/// Option SharpEdges: true edges and corners are near, smooth surfaces stay smooth, and every mesh
/// is valid and the same on any ranks.
#include "NearestTriangle.h"
#include "RandomDraw.h"
#include "RankMeshes.h"
#include "SharpCases.h"
#include "Sweep.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

MeshOptions OptionsOf(SharpEdgeMode mode, TetMethod method = TetMethod::Lattice)
{
  MeshOptions options;
  options.SharpEdges = mode;
  options.Method = method;
  return options;
}

/// Returns an empty string or the problem of a mesh; tolerance: of volumes.
std::string FindProblem(const Mesh& mesh, const MeshReport& report, double tolerance)
{
  if (!IsPositiveEverywhere(mesh))
  {
    return "inverted elements";
  }
  for (std::size_t m = 1; m < report.TargetVolume.size(); ++m)
  {
    const double error = MeasureVolume(mesh, static_cast<int>(m)) - report.TargetVolume[m];
    if (!(std::fabs(error) <= tolerance * report.TargetVolume[m]))
    {
      return "volume of material " + std::to_string(m) + " off by " +
        std::to_string(error / report.TargetVolume[m]);
    }
  }
  return FindTopologyProblem(mesh);
}

/// Returns one to three rotated boxes, cylinders and half-spaces that may overlap.
std::vector<Shape> DrawSolids(RandomDraw& draw, double n)
{
  std::vector<Shape> shapes;
  const int count = 1 + draw.Whole(0, 2);
  for (int s = 0; s < count; ++s)
  {
    const Vector3 at = draw.Vector(.4 * n, .6 * n);
    const Vector3 turned = draw.Vector(-90.0, 90.0);
    const int material = 1 + draw.Whole(0, 1);
    shapes.push_back(draw.Whole(0, 1) == 0
        ? MakeBox(material, at, draw.Vector(.35 * n, .6 * n), turned)
        : MakeCylinder(
            material, at, draw.Between(.2 * n, .3 * n), draw.Between(.35 * n, .6 * n), turned));
  }
  shapes.push_back(
    MakeHalfSpace(3, { { .5 * n, .5 * n, draw.Between(.2 * n, .5 * n) } }, draw.Vector(-1.0, 1.0)));
  return shapes;
}

} // namespace

TEST(SharpCases, EdgesAndCornersLieOnTheSurface)
{
  const std::map<std::string, double> volumes{ { "cube A", 1.2 * 1.2 * 1.2 },
    { "L", 1.1 * (1.2 * .55 + .6 * .65) }, { "wedge 45", 1.2 * 1.3 * 1.3 / 2.0 },
    { "cylinder", 1.3 * M_PI * .36 } };
  for (const std::string& name : ListSharpCases())
  {
    const int cells = 13;
    const SharpCase c = MakeSharpCase(name, cells);
    EXPECT_GT(c.Edges.size(), 300u) << name;
    for (const std::vector<Vector3>& points : { c.Edges, c.Corners })
    {
      for (const Vector3& x : points)
      {
        ASSERT_NEAR(c.Distance(x), 0.0, 1e-12) << name;
      }
    }
    const auto volume = volumes.find(name);
    double sum = 0.0;
    ForCells(c.Grid.Global(),
      [&](const Index3& cell) { sum += c.Fractions.Fraction(c.Grid.Linear(cell), 1); });
    if (volume != volumes.end())
    {
      EXPECT_NEAR(sum * std::pow(2.6 / cells, 3.0), volume->second, 1e-4) << name;
    }
  }
  EXPECT_THROW(MakeSharpCase("ball", 16), InputError);
}

TEST(SharpCases, TheNearestTriangleIsFound)
{
  RandomDraw draw(1);
  std::vector<NearestTriangle::Corners> triangles(200);
  for (NearestTriangle::Corners& triangle : triangles)
  {
    const Vector3 at = draw.Vector(0.0, 12.0);
    for (Vector3& corner : triangle)
    {
      corner = at + draw.Vector(-1.0, 1.0);
    }
  }
  const NearestTriangle nearest(triangles);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 x = draw.Vector(-6.0, 18.0);
    double expected = 1e300;
    for (const NearestTriangle::Corners& triangle : triangles)
    {
      expected = std::min(expected, DistanceToTriangle(x, triangle));
    }
    EXPECT_EQ(nearest.Distance(x), expected);
  }
  const NearestTriangle::Corners flat{ { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 4, 0 } } } };
  EXPECT_DOUBLE_EQ(DistanceToTriangle({ { 1, 1, -3 } }, flat), 3.0);
  EXPECT_DOUBLE_EQ(DistanceToTriangle({ { 3, 3, 0 } }, flat), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(DistanceToTriangle({ { -3, -4, 0 } }, flat), 5.0);
}

/// Returns the numbers of surfaces, curves and vertices; with a matrix the domain has its own.
std::array<Index, 3> GeometryOf(const std::string& name)
{
  static const std::map<std::string, std::array<Index, 3>> others{ { "L", { { 8, 18, 12 } } },
    { "cylinder", { { 3, 2, 0 } } }, { "wedge 45", { { 5, 9, 6 } } },
    { "cube A in matrix", { { 12, 24, 16 } } } };
  const auto at = others.find(name);
  return at == others.end() ? std::array<Index, 3>{ { 6, 12, 8 } } : at->second;
}

class SharpSolids : public ::testing::TestWithParam<std::string>
{
};

TEST_P(SharpSolids, EdgesAndCornersAreHeld)
{
  const std::string name = this->GetParam();
  const bool isAcute = name == "wedge 45", isCube = name.find("cube") == 0;
  const SharpCase c = MakeSharpCase(name, 32);
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = MakeHexMesh(c.Grid, c.Fractions, OptionsOf(SharpEdgeMode::On), runtime, report);
  const SharpFigures figures = MeasureSharp(c, mesh, report);
  std::printf("%s: edges %.3f rms, corners %.3f cells, scaled Jacobian %.3f\n", c.Name.c_str(),
    figures.EdgesToMesh.RootMeanSquare, figures.CornersToNodes.Largest,
    report.MinimumScaledJacobian);
  EXPECT_EQ(FindProblem(mesh, report, 1e-6), "");
  EXPECT_LE(figures.EdgesToMesh.RootMeanSquare, isAcute ? 0.1 : 0.05);
  EXPECT_LE(figures.CornersToNodes.Largest, isAcute ? 0.55 : 0.2);
  EXPECT_GE(report.MinimumScaledJacobian, isCube ? 0.47 : 0.40);
  EXPECT_EQ((std::array<Index, 3>{
              { report.NumberOfSurfaces, report.NumberOfCurves, report.NumberOfVertices } }),
    GeometryOf(name));
}

INSTANTIATE_TEST_SUITE_P(All, SharpSolids, ::testing::ValuesIn(ListSharpCases()),
  [](const ::testing::TestParamInfo<std::string>& info)
  {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

/// In few cells, edges are found in part. Weaker limits find the gaps between the parts; without
/// these, the edges here are 0.085 of a cell off.
TEST(SharpEdges, EdgesInGapsAreFound)
{
  const SharpCase c = MakeSharpCase("L", 16);
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = MakeHexMesh(c.Grid, c.Fractions, OptionsOf(SharpEdgeMode::On), runtime, report);
  EXPECT_LE(MeasureSharp(c, mesh, report).EdgesToMesh.RootMeanSquare, 0.072);
}

TEST(SharpEdges, WhatIsSmoothStays)
{
  for (const char* name : { "sphere 8", "sphere 16", "ball of 3 sectors" })
  {
    const MeshCase c = MakeMeshCase(name);
    Runtime runtime;
    MeshReport report;
    const Mesh off = MakeHexMesh(c.Grid, c.Fractions, MeshOptions(), runtime, report);
    for (SharpEdgeMode mode : { SharpEdgeMode::On, SharpEdgeMode::Automatic })
    {
      EXPECT_TRUE(AreEqual(MakeHexMesh(c.Grid, c.Fractions, OptionsOf(mode), runtime, report), off))
        << name;
    }
  }
}

/// The default case shows that the option has an effect here.
TEST(SharpEdges, HasNoEffectWithOtherSurfaces)
{
  const SharpCase c = MakeSharpCase("cube A", 16);
  const auto isSame = [&](const MeshOptions& off)
  {
    MeshOptions on = off;
    on.SharpEdges = SharpEdgeMode::On;
    Runtime runtime;
    MeshReport report;
    return AreEqual(MakeHexMesh(c.Grid, c.Fractions, off, runtime, report),
      MakeHexMesh(c.Grid, c.Fractions, on, runtime, report));
  };
  MeshOptions iso, facets, still, stairs;
  iso.IsoValue = 0.4;
  facets.Smoothing = SmoothingMethod::GeometryBased;
  still.Smoothing = SmoothingMethod::Off;
  stairs.StairStep = true;
  EXPECT_FALSE(isSame(MeshOptions()));
  EXPECT_TRUE(isSame(iso));
  EXPECT_TRUE(isSame(facets));
  EXPECT_TRUE(isSame(still));
  EXPECT_TRUE(isSame(stairs));
}

TEST(SharpEdges, RandomSolidsAreValid)
{
  for (unsigned seed : ListSeeds(6))
  {
    RandomDraw draw(seed);
    const int n = 16;
    const CartesianGrid grid = MakeUnitGrid(n);
    const FractionField field = FractionsOfShapes(grid, DrawSolids(draw, n), 3);
    for (const ElementMaker& maker : ElementMakers)
    {
      Runtime runtime;
      MeshReport report;
      const Mesh mesh =
        maker.Make(grid, field, OptionsOf(SharpEdgeMode::On, maker.Tets), runtime, report);
      EXPECT_EQ(FindProblem(mesh, report, 1e-6), "") << maker.Name << ", seed " << seed;
    }
  }
}

TEST(SharpEdges, RandomLabelsAreValid)
{
  for (unsigned seed : ListSeeds(8))
  {
    const CartesianGrid grid = MakeUnitGrid(4 + seed % 6);
    const FractionField field = MakeRandomLabels(grid, 1 + seed % 4, seed % 2, seed);
    for (const ElementMaker& maker : ElementMakers)
    {
      MeshOptions options = OptionsOf(SharpEdgeMode::On, maker.Tets);
      options.MeshVoid = seed % 3 == 0;
      Runtime runtime;
      MeshReport report;
      const Mesh mesh = maker.Make(grid, field, options, runtime, report);
      EXPECT_EQ(FindProblem(mesh, report, 1.0), "") << maker.Name << ", seed " << seed;
    }
  }
}

TEST(SharpEdges, RanksMakeTheSameMesh)
{
  for (const char* name : { "cube A", "L", "cube A in matrix" })
  {
    const SharpCase c = MakeSharpCase(name, 12);
    const IndexBox& box = c.Grid.Global();
    for (const ElementMaker& maker : ElementMakers)
    {
      SCOPED_TRACE(std::string(name) + ", " + maker.Name);
      CompareWithSerial(c.Grid, c.Fractions, { CutBox(box, 2), CutBox(box, 3, 0), CutBox(box, 8) },
        OptionsOf(SharpEdgeMode::On, maker.Tets), maker.Make);
    }
  }
}

TEST(SharpEdges, RanksChooseTheSamePairs)
{
  const SharpCase c = MakeSharpCase("L", 16);
  CompareWithSerial(c.Grid, c.Fractions,
    { CutBox(c.Grid.Global(), 3, 1), CutBox(c.Grid.Global(), 8) },
    OptionsOf(SharpEdgeMode::Automatic));
}
