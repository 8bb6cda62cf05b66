/// Options, grids, and guarantees that hold for all of them.
#include "Geometry/Quality.h"
#include "MeshCases.h"
#include "Phases/MeshOfCells.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

Mesh Make(const CartesianGrid& grid, const FractionField& fractions, const MeshOptions& options,
  MeshReport& report)
{
  Runtime runtime;
  return MakeHexMesh(grid, fractions, options, runtime, report);
}

/// Returns a grid whose widths grow and shrink by up to 1.3 per cell, anisotropically.
CartesianGrid MakeRectilinearGrid(int n)
{
  std::array<std::vector<double>, 3> x;
  for (int a = 0; a < 3; ++a)
  {
    double at = 10.0 * a;
    for (int i = 0; i <= n; ++i)
    {
      x[a].push_back(at);
      at += (1.0 + a) * (1.0 + 0.5 * std::sin(0.5 * i + a));
    }
  }
  return CartesianGrid(x);
}

class AbortingRuntime : public Runtime
{
public:
  explicit AbortingRuntime(double when) : When(when) {}
  void Progress(double fraction, const char*) override
  {
    EXPECT_GE(fraction, this->Last);
    EXPECT_LE(fraction, 1.0);
    this->Last = fraction;
    if (fraction >= this->When)
    {
      throw Aborted();
    }
  }

private:
  double When, Last = 0.0;
};

} // namespace

TEST(Options, StairStepMovesNothing)
{
  const MeshCase c = MakeMeshCase("ball and plate");
  MeshOptions options;
  options.StairStep = true;
  MeshReport report;
  const Mesh mesh = Make(c.Grid, c.Fractions, options, report);
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  for (double x : mesh.Points)
  {
    ASSERT_EQ(x, std::floor(x));
  }
  for (Index id : mesh.ElementIds)
  {
    ASSERT_EQ((id - 1) % 7, 0);
  }
  EXPECT_EQ(report.MinimumScaledJacobian, 1.0);
  EXPECT_DOUBLE_EQ(report.MeshVolume[1] + report.MeshVolume[2], mesh.ElementIds.size());
}

TEST(Options, SmoothingOffKeepsTheStairsAndItsVolume)
{
  const MeshCase c = MakeMeshCase("sphere 16");
  MeshOptions options;
  options.Smoothing = SmoothingMethod::Off;
  MeshReport report;
  const Mesh mesh = Make(c.Grid, c.Fractions, options, report);
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_GE(report.MinimumScaledJacobian, 0.43); // guaranteed by the mesh before smoothing
  EXPECT_NEAR(MeasureVolume(mesh, 1), report.MeshVolume[1], 1e-9 * report.MeshVolume[1]);
  EXPECT_EQ(report.MeshVolume[1], std::round(report.MeshVolume[1]));
}

TEST(Options, MeshVoidFillsTheDomain)
{
  const MeshCase c = MakeMeshCase("ball of 3 sectors");
  MeshOptions options;
  options.MeshVoid = true;
  MeshReport report;
  const Mesh mesh = Make(c.Grid, c.Fractions, options, report);
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_TRUE(IsPositiveEverywhere(mesh));
  double volume = 0.0;
  for (int m = 0; m <= 3; ++m)
  {
    volume += MeasureVolume(mesh, m);
    EXPECT_NEAR(report.MeshVolume[m], report.TargetVolume[m], 1e-5 * report.TargetVolume[m]);
  }
  EXPECT_NEAR(volume, 24.0 * 24.0 * 24.0, 1e-8);
  EXPECT_EQ(report.NumberOfFragments, 4);
}

TEST(Options, GeometryBasedStaysOnTheFacets)
{
  for (const char* name : { "sphere 16", "ball of 3 sectors", "gyroid" })
  {
    const MeshCase c = MakeMeshCase(name);
    MeshOptions options;
    options.Smoothing = SmoothingMethod::GeometryBased;
    Runtime runtime;
    const MeshFigures figures = MeasureCase(c, options, runtime);
    std::printf("geometry based %s", FormatFigures(name, figures).c_str());
    EXPECT_GE(figures.Report.MinimumScaledJacobian, 0.45) << name;
    EXPECT_LE(figures.Distance.RootMeanSquare, 0.06) << name;
    EXPECT_LE(figures.VolumeError, 1e-4) << name;
  }
}

TEST(Options, HigherTargetJacobianGivesBetterShapes)
{
  const MeshCase c = MakeMeshCase("plate 2 thick");
  double last = 0.0;
  for (double target : { 0.4, 0.5, 0.6 })
  {
    MeshOptions options;
    options.TargetScaledJacobian = target;
    MeshReport report;
    Make(c.Grid, c.Fractions, options, report);
    EXPECT_GT(report.MinimumScaledJacobian, last);
    last = report.MinimumScaledJacobian;
  }
}

TEST(Options, IsoValueMovesTheSurface)
{
  const MeshCase c = MakeMeshCase("sphere 16");
  std::vector<double> volumes;
  for (double iso : { 0.2, 0.5, 0.8 })
  {
    MeshOptions options;
    options.IsoValue = iso;
    MeshReport report;
    const Mesh mesh = Make(c.Grid, c.Fractions, options, report);
    EXPECT_EQ(FindTopologyProblem(mesh), "");
    volumes.push_back(MeasureVolume(mesh, 1));
  }
  EXPECT_GT(volumes[0], 1.05 * volumes[1]);
  EXPECT_LT(volumes[2], 0.95 * volumes[1]);
}

TEST(Options, OutOfRangeIsRejected)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  MeshOptions iso, target;
  iso.IsoValue = 1.0;
  target.TargetScaledJacobian = 1.0;
  MeshReport report;
  EXPECT_THROW(Make(c.Grid, c.Fractions, iso, report), InputError);
  EXPECT_THROW(Make(c.Grid, c.Fractions, target, report), InputError);
  MeshOptions levels;
  levels.Levels.Refinements = -1;
  Runtime runtime;
  EXPECT_THROW(MakeHexMesh(c.Grid, c.Fractions, levels, runtime, report), InputError);
  EXPECT_THROW(MakeTetMesh(c.Grid, c.Fractions, levels, runtime, report), InputError);
}

TEST(Grids, RectilinearAndAnisotropic)
{
  const CartesianGrid grid = MakeRectilinearGrid(24);
  Vector3 middle, radii;
  for (int a = 0; a < 3; ++a)
  {
    middle[a] = 0.5 * (grid.Coordinates(a).front() + grid.Coordinates(a).back());
    radii[a] = 0.35 * (grid.Coordinates(a).back() - grid.Coordinates(a).front());
  }
  const std::vector<Shape> shapes{ MakeEllipsoid(1, middle, radii) };
  MeshReport report;
  const Mesh mesh = Make(grid, FractionsOfShapes(grid, shapes), MeshOptions(), report);
  const Distances distances =
    MeasureDistances(mesh, [&](const Vector3& x) { return SignedDistance(shapes[0], x); });
  const double h = grid.MeanWidth();
  std::printf(
    "ellipsoid in cells of .5..1.5 x 1..3 x 1.5..4.5: %zu hexes, scaled Jacobian %.3f / %.3f, "
    "distance %.3f / %.4f mean cells\n",
    mesh.ElementIds.size(), report.MinimumScaledJacobian, report.MeanScaledJacobian,
    distances.Largest / h, distances.RootMeanSquare / h);
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_TRUE(IsPositiveEverywhere(mesh));
  EXPECT_GE(report.MinimumScaledJacobian, 0.45);
  EXPECT_LE(distances.RootMeanSquare, 0.06 * h);
  EXPECT_NEAR(MeasureVolume(mesh, 1), report.TargetVolume[1], 1e-5 * report.TargetVolume[1]);
}

TEST(Grids, OneCellThick)
{
  const CartesianGrid grid = MakeUnitGrid(8, 8, 1);
  const FractionField field = MakeRandomLabels(grid, 2, 0, 3);
  MeshReport report;
  const Mesh mesh = Make(grid, field, MeshOptions(), report);
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_TRUE(IsPositiveEverywhere(mesh));
}

TEST(Grids, EmptyAndFull)
{
  const CartesianGrid grid = MakeUnitGrid(5);
  for (int label : { 0, 1 })
  {
    MeshReport report;
    const Mesh mesh =
      Make(grid, MakeLabels(grid, 1, [=](const Index3&) { return label; }), MeshOptions(), report);
    EXPECT_EQ(mesh.ElementIds.size(), label * 125u);
    EXPECT_EQ(report.NumberOfSurfaces, label * 6);
    EXPECT_EQ(report.NumberOfCurves, label * 12);
    EXPECT_EQ(report.NumberOfVertices, label * 8);
  }
}

TEST(Promises, ThreadsDoNotChangeTheMesh)
{
  for (const char* name : { "ball and plate", "polycrystal" })
  {
    const MeshCase c = MakeMeshCase(name);
    MeshReport report;
    Runtime serial;
    ThreadedRuntime threaded;
    const Mesh a = MakeHexMesh(c.Grid, c.Fractions, MeshOptions(), serial, report);
    const Mesh b = MakeHexMesh(c.Grid, c.Fractions, MeshOptions(), threaded, report);
    EXPECT_TRUE(AreEqual(a, b)) << name;
    for (TetMethod method : { TetMethod::Cells, TetMethod::Lattice })
    {
      MeshOptions options;
      options.Method = method;
      const Mesh p = MakeTetMesh(c.Grid, c.Fractions, options, serial, report);
      const Mesh q = MakeTetMesh(c.Grid, c.Fractions, options, threaded, report);
      EXPECT_TRUE(AreEqual(p, q)) << name << " as tets";
    }
  }
}

TEST(Promises, AbortLeavesAtEveryStage)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  for (double when : { 0.0, 0.05, 0.1, 0.12, 0.15, 0.2, 0.4, 0.8, 0.95 })
  {
    AbortingRuntime runtime(when), another(when);
    MeshReport report;
    EXPECT_THROW(MakeHexMesh(c.Grid, c.Fractions, MeshOptions(), runtime, report), Aborted);
    EXPECT_THROW(MakeTetMesh(c.Grid, c.Fractions, MeshOptions(), another, report), Aborted);
  }
}

TEST(Geometry, QuadsPointFromTheSecondMaterialToTheFirst)
{
  const MeshCase c = MakeMeshCase("cut cylinder");
  MeshReport report;
  const Mesh mesh = Make(c.Grid, c.Fractions, MeshOptions(), report);
  // With one material the quads are its boundary, directed outward: the
  // divergence theorem gives the volume.
  double volume = 0.0;
  for (std::size_t q = 0; q < mesh.Surfaces.DomainSide.size(); ++q)
  {
    const double* x[4];
    for (int p = 0; p < 4; ++p)
    {
      x[p] = mesh.Points.data() + 3 * mesh.Surfaces.Points[4 * q + p];
    }
    const double d[2][3] = { { x[2][0] - x[0][0], x[2][1] - x[0][1], x[2][2] - x[0][2] },
      { x[3][0] - x[1][0], x[3][1] - x[1][1], x[3][2] - x[1][2] } };
    const double area = 0.5 * (d[0][0] * d[1][1] - d[0][1] * d[1][0]); // z component
    volume += area * 0.25 * (x[0][2] + x[1][2] + x[2][2] + x[3][2]);
  }
  EXPECT_NEAR(volume, report.MeshVolume[1], 1e-3 * report.MeshVolume[1]);
}

TEST(Fragments, AreNumberedByTheirLowestCell)
{
  const CartesianGrid grid = MakeUnitGrid(9, 3, 3);
  const FractionField field =
    MakeLabels(grid, 2, [](const Index3& p) { return p[0] % 3 == 2 ? 0 : (p[0] < 3 ? 2 : 1); });
  MeshOptions options;
  options.StairStep = true;
  MeshReport report;
  const Mesh mesh = Make(grid, field, options, report);
  EXPECT_EQ(report.NumberOfFragments, 3);
  for (std::size_t h = 0; h < mesh.ElementIds.size(); ++h)
  {
    const Index i = (mesh.ElementIds[h] - 1) / 7 % 9;
    EXPECT_EQ(mesh.Fragment[h], 1 + i / 3);
    EXPECT_EQ(mesh.Material[h], i < 3 ? 2 : 1);
  }
}

TEST(Quality, ScaledJacobianOfKnownHexes)
{
  double points[24] = { 0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0, 0, 0, 4, 2, 0, 4, 2, 3, 4, 0, 3, 4 };
  const Index hex[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  EXPECT_NEAR(HexScaledJacobian(points, hex), 1.0, 1e-15);
  for (int c = 4; c < 8; ++c)
  {
    points[3 * c] += 4.0; // sheared by 45 degrees
  }
  EXPECT_NEAR(HexScaledJacobian(points, hex), std::sqrt(0.5), 1e-15);
  for (double unit : { 0x1p-160, 0x1p320 }) // 7e-49, then 1e48
  {
    for (double& x : points)
    {
      x *= unit;
    }
    EXPECT_NEAR(HexScaledJacobian(points, hex), std::sqrt(0.5), 1e-15);
  }
  std::swap(points[0], points[3]);
  EXPECT_LT(HexScaledJacobian(points, hex), 0.0);
}

TEST(Quality, OfWholeCellsIsThatOfTheirCorners)
{
  MeshOptions options;
  options.StairStep = true;
  // Coordinates x of 1e12 do not resolve the widths along z.
  for (const auto& [origin, width] : { std::pair(0.0, 0.1), { -3.3, 0.1 }, { 1e12, 123.7 } })
  {
    std::array<std::vector<double>, 3> x;
    for (int i = 0; i <= 6; ++i)
    {
      x[0].push_back(origin + width * i);
      x[1].push_back(3.3 + 0.07 * i * i);
      x[2].push_back(-3.3 + 0.011 * i);
    }
    const CartesianGrid grid(x);
    const FractionField field =
      MakeLabels(grid, 2, [](const Index3& p) { return static_cast<int>(p[0] + p[2]) / 4; });
    MeshReport report;
    const Mesh mesh = Make(grid, field, options, report);
    double smallest = 1.0, sum = 0.0;
    for (std::size_t h = 0; h < mesh.ElementIds.size(); ++h)
    {
      const float value =
        static_cast<float>(HexScaledJacobian(mesh.Points.data(), mesh.Elements.data() + 8 * h));
      ASSERT_EQ(mesh.ScaledJacobian[h], value);
      smallest = std::min<double>(smallest, value);
      sum += value;
    }
    EXPECT_EQ(report.MinimumScaledJacobian, smallest);
    EXPECT_NEAR(report.MeanScaledJacobian, sum / mesh.ElementIds.size(), 1e-9);
    EXPECT_EQ(smallest < 1.0, origin == 1e12);
  }
}
