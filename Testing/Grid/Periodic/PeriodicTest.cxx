/// Periodic meshes: opposite sides are bitwise translates, the glued mesh is valid, and the mesh
/// does not depend on ranks.
#include "Fractions/GhostFractions.h"
#include "Fractions/RefineCells.h"
#include "GluedChecks.h"
#include "Octree/OctreeKeys.h"
#include "RankMeshes.h"
#include "Sweep.h"

#include "Phases/MeshOfCells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct Method
{
  const char* Name;
  MeshMaker Make;
  TetMethod Tets;
  Seam Sides;
};

const Method Methods[] = { { "FlatHexes", MakeHexMesh, TetMethod::Lattice, Seam::Flat },
  { "FlatLattice", MakeTetMesh, TetMethod::Lattice, Seam::Flat },
  { "FlatCells", MakeTetMesh, TetMethod::Cells, Seam::Flat },
  { "FreeHexes", MakeHexMesh, TetMethod::Lattice, Seam::Free },
  { "FreeLattice", MakeTetMesh, TetMethod::Lattice, Seam::Free },
  { "FreeCells", MakeTetMesh, TetMethod::Cells, Seam::Free } };

class Periodic : public ::testing::TestWithParam<Method>
{
};

/// Returns the largest distance of a point beyond the domain along periodic axes.
double FindExcess(const CartesianGrid& grid, const Mesh& mesh)
{
  double excess = 0.0;
  for (std::size_t at = 0; at < mesh.Points.size(); ++at)
  {
    const int a = static_cast<int>(at % 3);
    const std::vector<double>& x = grid.Coordinates(a);
    const double below = x[grid.Domain().Lower[a]] - mesh.Points[at];
    const double above = mesh.Points[at] - x[grid.Domain().Upper[a]];
    excess = grid.Period(a) > 0 ? std::max({ excess, below, above }) : excess;
  }
  return excess;
}

} // namespace

TEST_P(Periodic, RandomLabelsGiveValidTorus)
{
  const Method& method = this->GetParam();
  const Index sizes[] = { 3, 4, 7, 8 };
  double excess = 0.0;
  for (unsigned seed : ListSeeds(16))
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Index3 n{ { sizes[seed % 4], sizes[(seed / 2 + 1) % 4], sizes[(seed / 3) % 4] } };
    const int axes = 1 + static_cast<int>(seed % 7);
    const CartesianGrid grid =
      MakePeriodicGrid(n, { { (axes & 1) != 0, (axes & 2) != 0, (axes & 4) != 0 } }, method.Sides);
    MeshOptions options;
    options.Method = method.Tets;
    options.MeshVoid = seed % 2 == 0;
    const FractionField field = MakeRandomPeriodic(grid, 2, seed % 3 == 0 ? 1 : 0, seed);
    Runtime alone;
    MeshReport report;
    const Mesh mesh = method.Make(grid, field, options, alone, report);
    EXPECT_TRUE(IsPositiveEverywhere(mesh));
    EXPECT_EQ(FindConformityProblem(mesh), "");
    EXPECT_EQ(FindGluedProblem(grid, mesh, options.MeshVoid, report.NumberOfFragments), "");
    excess = std::max(excess, FindExcess(grid, mesh));
  }
  // Flat sides stay in their planes, free sides follow interfaces.
  EXPECT_TRUE(method.Sides == Seam::Flat ? excess < 1e-12 : excess > 0.1) << excess;
}

/// With free sides, a body across the corner of the cell gets the same mesh as one in its middle.
TEST_P(Periodic, PlaceOfSidesDoesNotMatter)
{
  const Method& method = this->GetParam();
  if (method.Sides == Seam::Flat)
  {
    GTEST_SKIP() << "flat sides cut bodies";
  }
  const CartesianGrid grid =
    MakePeriodicGrid({ { 12, 12, 12 } }, { { true, true, true } }, method.Sides);
  MeshReport reports[2];
  std::size_t elements[2];
  for (const int place : { 0, 1 })
  {
    const FractionField field = SamplePeriodic(grid, 1, 4,
      [&](const Vector3& x)
      {
        double squares = 0.0;
        for (double coordinate : x)
        {
          const double away = std::fabs(coordinate - 6.0 * place);
          squares += std::pow(std::min(away, 12.0 - away), 2);
        }
        return squares < 4.2 * 4.2 ? 1 : 0;
      });
    MeshOptions options;
    options.Method = method.Tets;
    Runtime alone;
    elements[place] = method.Make(grid, field, options, alone, reports[place]).ElementIds.size();
  }
  EXPECT_EQ(elements[0], elements[1]);
  EXPECT_EQ(reports[0].NumberOfFragments, 1);
  EXPECT_NEAR(reports[0].MinimumScaledJacobian, reports[1].MinimumScaledJacobian, 1e-4);
  EXPECT_NEAR(reports[0].MeshVolume[1], reports[0].TargetVolume[1], 1e-5);
}

/// Returns void with a few balls, some across sides, in base cells of 2^refinements cells.
FractionField MakeBalls(const CartesianGrid& grid, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<std::array<double, 4>> balls(2);
  for (auto& ball : balls)
  {
    ball = { { uniform(random), uniform(random), uniform(random), 0.1 + 0.1 * uniform(random) } };
  }
  return MakePeriodicLabels(grid, 2,
    [&](const Index3& cell)
    {
      for (std::size_t b = 0; b < balls.size(); ++b)
      {
        double squares = 0.0;
        for (int a = 0; a < 3; ++a)
        {
          const double size = static_cast<double>(grid.Domain().Size(a));
          const double away = std::abs((static_cast<double>(cell[a]) + 0.5) / size - balls[b][a]);
          squares += std::pow(std::min(away, 1.0 - away), 2);
        }
        if (squares < balls[b][3] * balls[b][3])
        {
          return static_cast<int>(b) + 1;
        }
      }
      return 0;
    });
}

/// Returns a grid of cubes whose base cells have 2^refinements cells along each axis.
CartesianGrid MakeRefinedGrid(unsigned seed, int refinements, Seam seam)
{
  const Index n = (6 + 2 * static_cast<Index>(seed % 3)) << refinements;
  const int axes = 1 + static_cast<int>(seed % 7);
  return MakePeriodicGrid({ { n, n, n } },
    { { (axes & 1) != 0, (axes & 2) != 0, (axes & 4) != 0 } }, seam, GhostLayers << refinements);
}

class PeriodicLevels : public ::testing::TestWithParam<Method>
{
};

TEST_P(PeriodicLevels, GiveValidTorus)
{
  const Method& method = this->GetParam();
  for (unsigned seed : ListSeeds(6))
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    MeshOptions options;
    options.Method = method.Tets;
    options.MeshVoid = seed % 4 < 2;
    options.Levels.Refinements = 1 + static_cast<int>(seed % 2);
    const CartesianGrid grid = MakeRefinedGrid(seed, options.Levels.Refinements, method.Sides);
    Runtime alone;
    MeshReport report;
    const Mesh mesh = method.Make(grid, MakeBalls(grid, seed), options, alone, report);
    Index families = 0;
    for (const MeshReport::Level& level : report.Levels)
    {
      families += level.Families;
    }
    EXPECT_GT(families, 0);
    EXPECT_TRUE(IsPositiveEverywhere(mesh));
    EXPECT_EQ(FindConformityProblem(mesh), "");
    if (method.Sides == Seam::Flat)
    {
      EXPECT_LT(FindExcess(grid, mesh), 1e-12);
    }
    EXPECT_EQ(FindGluedProblem(grid, mesh, options.MeshVoid, report.NumberOfFragments), "");
  }
}

/// Returns families at random places of the domain, for one refinement.
std::vector<Index> ListRandomFamilies(const CartesianGrid& grid, unsigned seed)
{
  std::mt19937 random(seed);
  const CartesianGrid base = ChangeLevel(grid, -1, 0);
  const OctreeKeys lattice(base, 1);
  std::vector<Index> keys;
  ForCells(ChangeLevel(base.Domain(), -1),
    [&](const Index3& family)
    {
      if (random() % 12 == 0)
      {
        keys.push_back(lattice.FamilyKey(0, family));
      }
    });
  return keys;
}

/// Few families are refined, so that interfaces cross cells of both levels and transition cells.
TEST_P(PeriodicLevels, InterfacesAcrossLevelsGiveValidTorus)
{
  const Method& method = this->GetParam();
  if (method.Make != MakeHexMesh)
  {
    GTEST_SKIP() << "tetrahedra need fine cells at interfaces";
  }
  for (unsigned seed : ListSeeds(6))
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    MeshOptions options;
    options.MeshVoid = seed % 2 == 0;
    options.Levels.Refinements = 1;
    options.Levels.FineInterfaces = false;
    CartesianGrid grid = MakeRefinedGrid(seed, 1, method.Sides);
    options.Levels.Families = { ListRandomFamilies(grid, seed) };
    FractionField field = MakePeriodicPolycrystal(grid, seed, 5);
    Runtime alone;
    WidenGrid(LayersFor(options.Levels), alone.Group(), grid, field);
    MeshReport report;
    const Mesh mesh = MakeHexMesh(grid, field, options, alone, report);
    EXPECT_GT(report.TransitionCells, 0);
    EXPECT_GT(report.Levels[0].Cells, 0);
    EXPECT_TRUE(IsPositiveEverywhere(mesh));
    EXPECT_EQ(FindConformityProblem(mesh), "");
    EXPECT_EQ(FindGluedProblem(grid, mesh, options.MeshVoid, report.NumberOfFragments), "");
    if (method.Sides == Seam::Flat)
    {
      EXPECT_LT(FindExcess(grid, mesh), 1e-12);
    }
  }
}

TEST_P(PeriodicLevels, RanksGiveTheSameMesh)
{
  const Method& method = this->GetParam();
  for (unsigned seed : ListSeeds(2))
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    MeshOptions options;
    options.Method = method.Tets;
    options.MeshVoid = true;
    options.Levels.Refinements = 1 + static_cast<int>(seed % 2);
    const CartesianGrid grid = MakeRefinedGrid(seed + 4, options.Levels.Refinements, method.Sides);
    const FractionField field = MakeBalls(grid, seed);
    const RankMesh alone = MakeAlone(grid, field, options, method.Make);
    for (int ranks : { 2, 3, 8 })
    {
      SCOPED_TRACE(std::to_string(ranks) + " ranks");
      const std::vector<IndexBox> boxes = CutBaseBox(grid, options.Levels.Refinements, ranks);
      EXPECT_EQ(FindDifference(MakeOnRanks(grid, field, boxes, options, method.Make), alone), "");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, PeriodicLevels, ::testing::ValuesIn(Methods),
  [](const auto& info) { return std::string(info.param.Name); });

TEST_P(Periodic, RanksGiveTheSameMesh)
{
  const Method& method = this->GetParam();
  for (unsigned seed : ListSeeds(3))
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const CartesianGrid grid =
      MakePeriodicGrid({ { 8, 7, 6 } }, { { seed % 3 != 1, true, seed % 3 != 2 } }, method.Sides);
    const FractionField field = MakeRandomPeriodic(grid, 3, 0, seed);
    MeshOptions options;
    options.Method = method.Tets;
    const RankMesh alone = MakeAlone(grid, field, options, method.Make);
    for (int ranks : { 2, 3, 8 })
    {
      SCOPED_TRACE(std::to_string(ranks) + " ranks");
      std::vector<IndexBox> boxes = CutBox(grid.Domain(), ranks);
      boxes.push_back(IndexBox());
      EXPECT_EQ(FindDifference(MakeOnRanks(grid, field, boxes, options, method.Make), alone), "");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Periodic, ::testing::ValuesIn(Methods),
  [](const auto& info) { return std::string(info.param.Name); });

/// Sums that decide between equal fractions of copies must not depend on rounded coordinates.
TEST(PeriodicGrid, CopiesOfCellsHaveTheirWidths)
{
  std::vector<double> x;
  for (int i = 0; i <= 7; ++i)
  {
    x.push_back(0.1 + std::pow(1.3, i));
  }
  const CartesianGrid grid = CartesianGrid::Covering(
    { x, x, x }, IndexBox{ { 0, 0, 0 }, { 7, 7, 7 } }, { true, true, false }, Seam::Free, 4);
  int rounded = 0;
  ForCells(grid.Global(),
    [&](const Index3& cell)
    {
      const Index3 own = grid.Canonical(cell);
      EXPECT_EQ(grid.CellVolume(cell), grid.CellVolume(own));
      const std::vector<double>& y = grid.Coordinates(1);
      rounded += y[cell[1] + 1] - y[cell[1]] != grid.Width(1, own[1]);
    });
  EXPECT_GT(rounded, 0);
}
