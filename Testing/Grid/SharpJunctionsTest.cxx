/// Option SharpEdges where edges end: on another material, at a side of
/// the domain, on a finer level.
#include "MeshChecks.h"
#include "SharpCases.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Cells = 32;
constexpr double Turn = 0.4; // rotation of a box about z, radians
constexpr double HalfWidth = 0.2 * Cells, Bottom = 0.2 * Cells, Top = 0.7 * Cells;
constexpr double PlateTop = 0.3137 * Cells;

/// Returns a rotated box whose vertical edges are expected from the height `visible`.
SharpCase MakeBoxCase(std::vector<Shape> others, double bottom, double visible, double top)
{
  const double middle = 0.5 * Cells;
  std::vector<Shape> shapes{ MakeBox(1, { { middle, middle, 0.5 * (bottom + top) } },
    { { 2.0 * HalfWidth, 2.0 * HalfWidth, top - bottom } },
    { { 0.0, 0.0, Turn * 180.0 / M_PI } }) };
  shapes.insert(shapes.end(), others.begin(), others.end());
  const CartesianGrid grid = MakeUnitGrid(Cells);
  SharpCase c{ "box", grid, FractionsOfShapes(grid, shapes), {}, {}, {} };
  c.Distance = [](const Vector3&) { return 0.0; };
  for (int corner = 0; corner < 4; ++corner)
  {
    const double u = corner & 1 ? HalfWidth : -HalfWidth, v = corner & 2 ? HalfWidth : -HalfWidth;
    const double x = middle + std::cos(Turn) * u - std::sin(Turn) * v;
    const double y = middle + std::sin(Turn) * u + std::cos(Turn) * v;
    for (double z = visible; z < top; z += 0.1)
    {
      c.Edges.push_back({ { x, y, z } });
    }
    c.Corners.push_back({ { x, y, top } });
  }
  return c;
}

SharpFigures MeasureHexes(const SharpCase& c, const MeshOptions& options, MeshReport& report)
{
  Runtime runtime;
  const GridLayers layers = LayersFor(options.Levels);
  const CartesianGrid grid(c.Grid.Coordinates(), c.Grid.Global(), layers.Ghosts, layers.Hexes);
  const Mesh mesh = MakeHexMesh(grid, c.Fractions, options, runtime, report);
  EXPECT_TRUE(IsPositiveEverywhere(mesh));
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  const SharpFigures figures = MeasureSharp(c, mesh, report);
  std::printf("edges off by %.3f rms, %.3f at most, corners by %.3f; %lld surfaces, %lld curves, "
              "%lld vertices; scaled Jacobian %.3f\n",
    figures.EdgesToMesh.RootMeanSquare, figures.EdgesToMesh.Largest, figures.CornersToNodes.Largest,
    static_cast<long long>(report.NumberOfSurfaces), static_cast<long long>(report.NumberOfCurves),
    static_cast<long long>(report.NumberOfVertices), report.MinimumScaledJacobian);
  return figures;
}

void ExpectSharp(const SharpCase& c, Index surfaces, Index curves, Index vertices)
{
  MeshOptions options;
  options.SharpEdges = SharpEdgeMode::Automatic;
  MeshReport report;
  const SharpFigures figures = MeasureHexes(c, options, report);
  EXPECT_LT(figures.EdgesToMesh.RootMeanSquare, 0.045);
  EXPECT_LT(figures.EdgesToMesh.Largest, 0.15);
  EXPECT_LT(figures.CornersToNodes.Largest, 0.2);
  EXPECT_EQ(report.NumberOfSurfaces, surfaces);
  EXPECT_EQ(report.NumberOfCurves, curves);
  EXPECT_EQ(report.NumberOfVertices, vertices);
}

} // namespace

/// A box stuck in a plate has 5 sides above and 5 below; the plate has a top and 5 domain sides.
TEST(SharpJunctions, EdgesEndOnAnotherMaterial)
{
  ExpectSharp(MakeBoxCase({ MakeHalfSpace(2, { { 0.0, 0.0, PlateTop } }, { { 0.0, 0.0, 1.0 } }) },
                Bottom, PlateTop, Top),
    16, 32, 20);
}

TEST(SharpJunctions, EdgesEndAtASideOfTheDomain)
{
  ExpectSharp(MakeBoxCase({}, -0.1 * Cells, 0.0, 0.45 * Cells), 6, 12, 8);
}

/// With coarser cells inside and all interfaces in finest cells, the edges
/// equal the uniform mesh's.
TEST(SharpJunctions, FinestCellsHaveEdges)
{
  const SharpCase c = MakeBoxCase({}, Bottom, Bottom, Top);
  MeshOptions options;
  options.SharpEdges = SharpEdgeMode::On;
  options.MeshVoid = true;
  MeshReport uniform, refined;
  const SharpFigures expected = MeasureHexes(c, options, uniform);
  options.Levels.Refinements = 2;
  const SharpFigures figures = MeasureHexes(c, options, refined);
  EXPECT_EQ(refined.EdgePoints, uniform.EdgePoints);
  EXPECT_EQ(refined.CornerPoints, uniform.CornerPoints);
  EXPECT_GT(refined.TransitionCells, 0);
  EXPECT_LT(expected.EdgesToMesh.RootMeanSquare, 0.045);
  EXPECT_NEAR(figures.EdgesToMesh.RootMeanSquare, expected.EdgesToMesh.RootMeanSquare, 1e-3);
}
