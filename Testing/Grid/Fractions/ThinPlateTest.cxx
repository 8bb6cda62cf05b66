/// Effect of refinement before meshing on thin films and rods.
#include "Base/Vector3.h"
#include "Fractions/RefineCells.h"
#include "MeshCases.h"
#include "Shapes/ShapesScenes.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct Thin
{
  std::string Name;
  int Cells;
  Shape Solid;
};

/// Counts the connected parts of the void.
Index CountVoids(const RefinedCells& cells)
{
  Runtime runtime;
  MeshOptions options;
  options.StairStep = options.MeshVoid = true;
  options.ComputeQuality = false;
  MeshReport report;
  const Mesh mesh = MakeHexMesh(cells.Grid, cells.Fractions, options, runtime, report);
  std::set<int> pieces;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    if (mesh.Material[e] == 0)
    {
      pieces.insert(mesh.Fragment[e]);
    }
  }
  return static_cast<Index>(pieces.size());
}

/// Returns points - edges + faces - hexes: 1 for a ball, 1 less for each hole through it.
Index EulerNumber(const Mesh& mesh)
{
  static const int edges[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 },
    { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
  static const int faces[6][4] = { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  std::set<std::array<Index, 2>> allEdges;
  std::set<std::array<Index, 4>> allFaces;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    const Index* corner = &mesh.Elements[8 * e];
    for (const auto& edge : edges)
    {
      const Index a = corner[edge[0]], b = corner[edge[1]];
      allEdges.insert({ { std::min(a, b), std::max(a, b) } });
    }
    for (const auto& face : faces)
    {
      std::array<Index, 4> f{ { corner[face[0]], corner[face[1]], corner[face[2]],
        corner[face[3]] } };
      std::sort(f.begin(), f.end());
      allFaces.insert(f);
    }
  }
  return static_cast<Index>(mesh.PointIds.size()) - static_cast<Index>(allEdges.size()) +
    static_cast<Index>(allFaces.size()) - static_cast<Index>(mesh.ElementIds.size());
}

struct ThinFigures
{
  MeshFigures Mesh; // distances in cells before halving
  Index Euler = 0, Voids = 0;
};

/// Halves all cells `halvings` times and meshes them.
ThinFigures MeasureThin(const Thin& thin, int halvings)
{
  Runtime runtime;
  const CartesianGrid grid = MakeUnitGrid(thin.Cells);
  RefinedCells cells{ grid, FractionsOfShapes(grid, { thin.Solid }) };
  for (int i = 0; i < halvings; ++i)
  {
    cells = RefineCells(cells.Grid, cells.Fractions, runtime);
  }
  const Shape solid = thin.Solid;
  const MeshCase c{ thin.Name, cells.Grid, cells.Fractions,
    [solid](int, int, const Vector3& x) { return SignedDistance(solid, x); }, 0, 0, 0, 0, 0 };
  ThinFigures figures;
  figures.Mesh = MeasureCase(c, MeshOptions(), runtime);
  figures.Euler = EulerNumber(figures.Mesh.Result);
  figures.Voids = CountVoids(cells);
  return figures;
}

Thin MakeThinPlate(double thickness, const Vector3& normal)
{
  char name[64];
  std::snprintf(name, sizeof(name), "plate (%g, %g, %g)", normal[0], normal[1], normal[2]);
  return { name, 24, MakePlate(1, { { 12.13, 11.79, 12.37 } }, normal, thickness) };
}

Thin MakeThinBox(double thickness)
{
  return { "square plate", 28,
    MakeBox(1, { { 14.13, 13.79, 14.37 } }, { { 16.0, 16.0, thickness } }, { { 33, 21, 10 } }) };
}

Thin MakeRod(double diameter)
{
  return { "rod", 28,
    MakeCylinder(1, { { 14.13, 13.79, 14.37 } }, 0.5 * diameter, 16.0, { { 33, 21, 10 } }) };
}

} // namespace

TEST(ThinPlate, OneHalvingKeepsAPlateOfOneCellWhole)
{
  for (const Vector3& normal : { Vector3{ { 1, 2, 3 } }, Vector3{ { 0.2, 1, 0.1 } } })
  {
    const ThinFigures f = MeasureThin(MakeThinPlate(1.0, normal), 1);
    EXPECT_EQ(f.Mesh.Report.NumberOfFragments, 1);
    EXPECT_EQ(f.Euler, 1) << "holes";
    EXPECT_EQ(f.Voids, 2);
    EXPECT_GT(f.Mesh.Report.MinimumScaledJacobian, 0.55);
    EXPECT_LT(f.Mesh.Distance.Largest, 0.15);
    EXPECT_LT(f.Mesh.VolumeError, 1e-5);
  }
}

TEST(ThinPlate, RodsAndRimsStayInOnePiece)
{
  for (const Thin& thin : { MakeRod(1.0), MakeThinBox(1.0) })
  {
    for (int halvings : { 1, 2 })
    {
      const ThinFigures f = MeasureThin(thin, halvings);
      EXPECT_EQ(f.Mesh.Report.NumberOfFragments, 1) << thin.Name;
      EXPECT_EQ(f.Euler, 1) << thin.Name;
      EXPECT_GT(f.Mesh.Report.MinimumScaledJacobian, 0.55) << thin.Name;
      EXPECT_LT(f.Mesh.VolumeError, 1e-5) << thin.Name;
    }
  }
}

/// Prints the table of the documentation. Run with --gtest_also_run_disabled_tests
/// --gtest_filter='ThinPlate*Table'; takes minutes.
TEST(ThinPlate, DISABLED_Table)
{
  std::printf(
    "| shape | thickness | halvings | pieces | Euler number | pieces of void | hexes | flips | "
    "min SJ | mean SJ | distance max/rms | volume / true |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (double thickness : { 0.5, 1.0, 1.5 })
  {
    for (const Thin& thin :
      { MakeThinPlate(thickness, { { 1, 2, 3 } }), MakeThinPlate(thickness, { { 0.2, 1, 0.1 } }),
        MakeThinBox(thickness), MakeRod(thickness) })
    {
      for (int halvings = 0; halvings <= 2; ++halvings)
      {
        const ThinFigures f = MeasureThin(thin, halvings);
        const MeshReport& report = f.Mesh.Report;
        std::printf(
          "| %s | %.1f | %d | %lld | %lld | %lld | %zu | %lld | %.3f | %.3f | %.3f/%.4f | %.6f |\n",
          thin.Name.c_str(), thickness, halvings, static_cast<long long>(report.NumberOfFragments),
          static_cast<long long>(f.Euler), static_cast<long long>(f.Voids), f.Mesh.Elements,
          static_cast<long long>(report.FlippedCells), report.MinimumScaledJacobian,
          report.MeanScaledJacobian, f.Mesh.Distance.Largest, f.Mesh.Distance.RootMeanSquare,
          report.MeshVolume[1] / report.TargetVolume[1]);
        std::fflush(stdout);
      }
    }
  }
}
