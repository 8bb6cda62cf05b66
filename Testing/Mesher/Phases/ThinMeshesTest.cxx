/// Meshes of films, threads and drops that are thinner than a cell.
#include "Cells/ThinShapes.h"
#include "MeshCases.h"
#include "RandomDraw.h"
#include "RankMeshes.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

MeshOptions OptionsOf(const ElementMaker& method)
{
  MeshOptions options;
  options.ThinParts = true;
  options.Method = method.Tets;
  return options;
}

/// Mesh of shapes of material 1 in unit cells, and what is measured of it.
struct ThinMesh
{
  Mesh Elements;
  MeshReport Report;
  double VolumeError = 0.0; // relative
  double Displaced = 0.0;   // share of the volume; 0 if there are no thin cells
};

ThinMesh MakeThin(const CartesianGrid& grid, const std::vector<Shape>& shapes,
  const ElementMaker& method = ElementMakers[0], bool thinParts = true)
{
  Runtime runtime;
  const FractionField fractions = FractionsOfShapes(grid, shapes);
  MeshOptions options = OptionsOf(method);
  options.ThinParts = thinParts;
  ThinMesh made;
  made.Elements = method.Make(grid, fractions, options, runtime, made.Report);
  made.VolumeError = made.Report.MeshVolume[1] / made.Report.TargetVolume[1] - 1.0;
  made.Displaced = made.Report.ThinPartCells > 0 ? made.Report.DisplacedVolume[1] : 0.0;
  return made;
}

void ExpectValid(const Mesh& mesh)
{
  EXPECT_TRUE(IsPositiveEverywhere(mesh));
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_EQ(FindFragmentProblem(mesh), "");
}

TEST(ThinMeshes, FilmsAreOneFragmentOfTheirVolume)
{
  const CartesianGrid grid = MakeUnitGrid(14);
  for (const ElementMaker& method : ElementMakers)
  {
    const bool isHexes = &method == ElementMakers;
    RandomDraw draw(4);
    for (const Vector3& normal : ListDirections(isHexes ? 20 : 4))
    {
      for (double thickness : { 0.4, 0.6, 0.8 })
      {
        const std::vector<Shape> film{ MakeFilm(draw.Vector(6.5, 7.5), normal, thickness) };
        const ThinMesh made = MakeThin(grid, film, method);
        char name[100];
        std::snprintf(name, sizeof name, "%s film %.2f %.2f %.2f of %.1f", method.Name, normal[0],
          normal[1], normal[2], thickness);
        SCOPED_TRACE(name);
        ExpectValid(made.Elements);
        EXPECT_EQ(made.Report.NumberOfFragments, 1);
        EXPECT_LT(std::abs(made.VolumeError), isHexes ? 0.02 : 0.08);
        EXPECT_LT(made.Displaced, isHexes ? 0.1 : 0.5);
        std::printf("%s: volume %+.3f %%, displaced %.1f %%, SJ %.3f\n", name,
          100.0 * made.VolumeError, 100.0 * made.Displaced, made.Report.MinimumScaledJacobian);
      }
    }
  }
}

TEST(ThinMeshes, DropsAndThreads)
{
  for (const ElementMaker& method : ElementMakers)
  {
    for (double volume : { 0.5, 1.0, 3.0 })
    {
      const ThinMesh made = MakeThin(MakeUnitGrid(18), MakeDrops(volume, 3), method);
      ExpectValid(made.Elements);
      EXPECT_EQ(made.Report.NumberOfFragments, 27) << method.Name << " " << volume;
      EXPECT_LT(std::abs(made.VolumeError), 1e-3) << method.Name << " " << volume;
      std::printf("%s drops %.1f: volume %+.4f %%, displaced %.1f %%, SJ %.3f\n", method.Name,
        volume, 100.0 * made.VolumeError, 100.0 * made.Displaced,
        made.Report.MinimumScaledJacobian);
    }
    for (const Vector3& direction : ListDirections(5))
    {
      const ThinMesh made =
        MakeThin(MakeUnitGrid(16), { MakeThread({ { 8.1, 7.8, 8.3 } }, direction, 0.7) }, method);
      ExpectValid(made.Elements);
      EXPECT_EQ(made.Report.NumberOfFragments, 1) << method.Name;
      EXPECT_GT(made.VolumeError, -1e-3) << method.Name;
      EXPECT_LT(made.VolumeError, &method == ElementMakers ? 0.8 : 5.0) << method.Name;
      std::printf("%s thread %.2f %.2f %.2f: volume %+.4f %%, displaced %.1f %%, SJ %.3f\n",
        method.Name, direction[0], direction[1], direction[2], 100.0 * made.VolumeError,
        100.0 * made.Displaced, made.Report.MinimumScaledJacobian);
    }
  }
}

TEST(ThinMeshes, ShellIsClosed)
{
  const CartesianGrid grid = MakeUnitGrid(20);
  const std::vector<Shape> shell{ MakeShell({ { 10.2, 9.9, 10.4 } }, 7.3, 0.4) };
  for (const ElementMaker& method : ElementMakers)
  {
    const ThinMesh made = MakeThin(grid, shell, method),
                   torn = MakeThin(grid, shell, method, false);
    ExpectValid(made.Elements);
    EXPECT_EQ(made.Report.NumberOfFragments, 1) << method.Name;
    EXPECT_LT(std::abs(made.VolumeError), 1e-3) << method.Name;
    std::printf("%s shell: volume %+.4f %%, displaced %.1f %%; without thin parts %+.1f %%\n",
      method.Name, 100.0 * made.VolumeError, 100.0 * made.Displaced, 100.0 * torn.VolumeError);
  }
}

// The film keeps its place: it does not take the volume of the ball, nor the ball that of the film.
TEST(ThinMeshes, FilmThroughABall)
{
  const CartesianGrid grid = MakeUnitGrid(20);
  const std::vector<Shape> shapes{ MakeFilm({ { 10.1, 9.8, 10.2 } }, { { 3, 2, 1 } }, 0.4),
    MakeSphere(1, { { 10.1, 9.8, 10.2 } }, 4.0) };
  for (const ElementMaker& method : ElementMakers)
  {
    const ThinMesh made = MakeThin(grid, shapes, method);
    const bool isHexes = &method == ElementMakers;
    ExpectValid(made.Elements);
    EXPECT_EQ(made.Report.NumberOfFragments, 1) << method.Name;
    // The film of Lattice would crumple if its elements were thinner.
    EXPECT_LT(
      std::abs(made.VolumeError), method.Tets == TetMethod::Lattice && !isHexes ? 0.3 : 1e-3)
      << method.Name;
    EXPECT_LT(made.Displaced, isHexes ? 0.1 : 0.4) << method.Name;
    std::printf("%s film through a ball: volume %+.4f %%, displaced %.1f %%, SJ %.3f\n",
      method.Name, 100.0 * made.VolumeError, 100.0 * made.Displaced,
      made.Report.MinimumScaledJacobian);
  }
}

TEST(ThinMeshes, ResolvedShapesKeepTheirMesh)
{
  for (const char* name : { "gyroid", "sphere 16", "polycrystal", "plate 2 thick" })
  {
    const MeshCase c = MakeMeshCase(name);
    for (const ElementMaker& method : ElementMakers)
    {
      Runtime runtime;
      MeshReport with, without;
      MeshOptions options = OptionsOf(method);
      const Mesh thin = method.Make(c.Grid, c.Fractions, options, runtime, with);
      options.ThinParts = false;
      EXPECT_TRUE(AreEqual(thin, method.Make(c.Grid, c.Fractions, options, runtime, without)))
        << name << " " << method.Name;
      EXPECT_EQ(with.ThinPartCells, 0);
    }
  }
}

TEST(ThinMeshes, SameOnAnyRanks)
{
  const CartesianGrid grid = MakeUnitGrid(20, 16, 18);
  std::vector<Shape> shapes = MakeDrops(0.7, 5);
  shapes.push_back(MakeFilm({ { 10, 8, 9 } }, { { 3, 2, 1 } }, 0.5));
  const FractionField fractions = FractionsOfShapes(grid, shapes);
  for (const ElementMaker& method : ElementMakers)
  {
    CompareWithSerial(grid, fractions,
      { CutBox(grid.Global(), 2), CutBox(grid.Global(), 3, 0), CutBox(grid.Global(), 5),
        CutBox(grid.Global(), 8) },
      OptionsOf(method), method.Make);
  }
}

} // namespace
