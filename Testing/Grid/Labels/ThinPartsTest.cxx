/// Thin parts get cells: films, threads and drops stay whole, other labels stay.
#include "Labels/ThinParts.h"

#include "Cells/CellParts.h"
#include "Cells/ThinShapes.h"
#include "MeshCases.h"
#include "RandomDraw.h"
#include "RankFields.h"
#include "Sweep.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double LeastThickness = 0.25;

/// Labels of all cells with thin parts, and these cells.
struct Labelled
{
  LabelArray Labels;
  std::vector<ThinCell> Thin;
};

Labelled LabelAll(const CartesianGrid& grid, const FractionField& fractions)
{
  Runtime runtime;
  Labelled result{ AssignMaterials(grid, fractions, 0.5), {} };
  result.Thin = LabelThinParts(
    grid, fractions, LeastThickness, Partition(grid, runtime.Group()), runtime, result.Labels);
  return result;
}

/// Counts the parts of material 1.
int CountParts(const CartesianGrid& grid, const LabelArray& labels)
{
  return CountCellParts(grid, Joins::Faces, [&](Index cell) { return labels[cell] == 1; });
}

/// Counts the parts of void.
int CountPartsOfRest(const CartesianGrid& grid, const LabelArray& labels)
{
  return CountCellParts(
    grid, Joins::FacesEdgesCorners, [&](Index cell) { return labels[cell] == 0; });
}

TEST(ThinParts, FilmsAreWholeAndSeparateTheirSides)
{
  const CartesianGrid grid = MakeUnitGrid(14);
  RandomDraw draw(2);
  for (const Vector3& normal : ListDirections(20))
  {
    for (double thickness : { 0.4, 0.55, 0.7, 0.8 })
    {
      const Vector3 point = draw.Vector(6.5, 7.5);
      const FractionField film = FractionsOfShapes(grid, { MakeFilm(point, normal, thickness) });
      const Labelled made = LabelAll(grid, film);
      SCOPED_TRACE(std::to_string(thickness) + " " + std::to_string(normal[0]) + " " +
        std::to_string(normal[1]) + " " + std::to_string(normal[2]));
      EXPECT_EQ(CountParts(grid, made.Labels), 1);
      EXPECT_EQ(CountPartsOfRest(grid, made.Labels), 2);
    }
  }
}

TEST(ThinParts, FilmOnASideOfTheDomain)
{
  const CartesianGrid grid = MakeUnitGrid(10);
  const Labelled made =
    LabelAll(grid, FractionsOfShapes(grid, { MakeFilm({ { 5, 5, 0.1 } }, { { 0, 0, 1 } }, 0.6) }));
  EXPECT_EQ(made.Thin.size(), 100u); // the film fills 0.4 of the cells at the side
  for (const ThinCell& thin : made.Thin)
  {
    EXPECT_EQ(grid.Position(thin.Cell)[2], 0);
    EXPECT_NEAR(thin.Load, 0.4, 1e-12);
  }
}

TEST(ThinParts, ShellsAndThreadsAreWhole)
{
  const CartesianGrid grid = MakeUnitGrid(20);
  const Labelled shell =
    LabelAll(grid, FractionsOfShapes(grid, { MakeShell({ { 10.2, 9.9, 10.4 } }, 7.3, 0.4) }));
  EXPECT_EQ(CountParts(grid, shell.Labels), 1);
  EXPECT_EQ(CountPartsOfRest(grid, shell.Labels), 2);
  for (double diameter : { 0.7, 1.0, 1.3 })
    for (const Vector3& direction : ListDirections(12))
    {
      const Labelled thread = LabelAll(grid,
        FractionsOfShapes(grid, { MakeThread({ { 10.1, 9.8, 10.3 } }, direction, diameter) }));
      EXPECT_EQ(CountParts(grid, thread.Labels), 1);
      EXPECT_EQ(CountPartsOfRest(grid, thread.Labels), 1);
    }
}

TEST(ThinParts, EachDropIsOnePart)
{
  const CartesianGrid grid = MakeUnitGrid(18);
  for (double volume : { 0.5, 0.7, 1.0, 2.0, 3.0 })
  {
    const Labelled made = LabelAll(grid, FractionsOfShapes(grid, MakeDrops(volume, 3)));
    EXPECT_EQ(CountParts(grid, made.Labels), 27) << volume;
  }
}

TEST(ThinParts, MaterialBelowTheLeastThicknessGetsNoCells)
{
  const CartesianGrid grid = MakeUnitGrid(12);
  const Labelled made =
    LabelAll(grid, FractionsOfShapes(grid, { MakeFilm({ { 6, 6, 6.5 } }, { { 0, 0, 1 } }, 0.2) }));
  EXPECT_TRUE(made.Thin.empty());
}

TEST(ThinParts, GapsBetweenBodiesStay)
{
  const CartesianGrid grid = MakeUnitGrid(12);
  for (double gap : { 0.6, 0.8, 1.0, 1.3 })
  {
    const double low = 6.5 - 0.5 * gap, high = 6.5 + 0.5 * gap;
    const FractionField bodies = FractionsOfShapes(grid,
      { MakeHalfSpace(1, { { 6, 6, low } }, { { 0, 0, 1 } }),
        MakeHalfSpace(1, { { 6, 6, high } }, { { 0, 0, -1 } }) });
    EXPECT_EQ(CountParts(grid, AssignMaterials(grid, bodies, 0.5)), 2) << gap;
    EXPECT_TRUE(LabelAll(grid, bodies).Thin.empty()) << gap;
  }
}

TEST(ThinParts, ResolvedShapesKeepTheirLabels)
{
  for (const std::string& name : ListMeshCases())
  {
    const MeshCase c = MakeMeshCase(name);
    EXPECT_TRUE(LabelAll(c.Grid, c.Fractions).Thin.empty()) << name;
  }
  const MeshCase crystal = MakePolycrystalCase(30, 24);
  EXPECT_TRUE(LabelAll(crystal.Grid, crystal.Fractions).Thin.empty());
}

/// Surfaces of these plates meet the sides of the domain at all angles.
TEST(ThinParts, ResolvedPlatesKeepTheirLabels)
{
  const CartesianGrid grid = MakeUnitGrid(17);
  RandomDraw draw(7);
  for (const Vector3& normal : ListDirections(20))
  {
    for (double thickness : { 2.1, 2.7, 3.5 })
    {
      const Vector3 point{ { draw.Between(8, 9), draw.Between(8, 9), draw.Between(8, 9) } };
      const FractionField plate = FractionsOfShapes(grid, { MakeFilm(point, normal, thickness) });
      EXPECT_TRUE(LabelAll(grid, plate).Thin.empty()) << thickness;
    }
  }
}

/// A body that fills little of the last cells before sides, edges and corners of the domain ends
/// there; it is no film along them.
TEST(ThinParts, BodiesThatEndAtSidesKeepTheirLabels)
{
  const CartesianGrid grid = MakeUnitGrid(9, 8, 7);
  const std::array<double, 3> depths{ { 0.12, 0.25, 0.45 } };
  for (double x : depths)
    for (double y : depths)
      for (double z : { 0.12, 0.45, 2.6 })
      {
        const Vector3 lower{ { 1 - x, 1 - y, 1 - z } }, upper{ { 8 + y, 7 + x, 6 + z } };
        const FractionField body =
          FractionsOfShapes(grid, { MakeBox(1, 0.5 * (lower + upper), upper - lower) });
        EXPECT_TRUE(LabelAll(grid, body).Thin.empty()) << x << " " << y << " " << z;
      }
}

/// Returns void with some small fractions, so few that no cell is inside of a cloud.
FractionField MakeDust(const CartesianGrid& grid, int materials, double share, unsigned seed)
{
  RandomDraw draw(seed);
  FractionField fractions(grid, materials);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      std::vector<FractionField::Part> parts;
      for (int m = 1; m <= materials && draw.Chance(share); ++m)
      {
        parts.push_back({ m, draw.Between(0.0, 0.9 / materials) });
      }
      fractions.SetParts(grid.Linear(p), parts);
    });
  return fractions;
}

TEST(ThinParts, EqualOnAnyRanks)
{
  const FieldChange change = [](const CartesianGrid& grid, const Partition& partition,
                               Runtime& runtime, FractionField& fractions)
  {
    LabelArray labels = AssignMaterials(grid, fractions, 0.5);
    const std::vector<ThinCell> thin =
      LabelThinParts(grid, fractions, LeastThickness, partition, runtime, labels);
    EXPECT_TRUE(partition.Group().Any(!thin.empty()));
    fractions = FractionField(WithClaims(fractions, labels, thin).Field());
  };
  const CartesianGrid grid = MakeUnitGrid(22, 18, 20);
  for (unsigned seed : ListSeeds(4))
  {
    EXPECT_EQ(FindRankProblem(grid, MakeDust(grid, 1 + seed % 3, 0.7, seed), change), "") << seed;
    EXPECT_EQ(FindRankProblem(grid, MakePatchyFractions(grid, 2, seed), change), "") << seed;
  }
  const FractionField film =
    FractionsOfShapes(grid, { MakeFilm({ { 11, 9, 10 } }, { { 3, 2, 1 } }, 0.5) });
  EXPECT_EQ(FindRankProblem(grid, film, change), "");
}

TEST(ThinParts, ClaimsAreTheLargestFractions)
{
  const CartesianGrid grid = MakeUnitGrid(14);
  const FractionField dust = MakeDust(grid, 3, 0.8, 5);
  const Labelled made = LabelAll(grid, dust);
  ASSERT_FALSE(made.Thin.empty());
  const WithClaims claims(dust, made.Labels, made.Thin);
  for (const ThinCell& thin : made.Thin)
  {
    EXPECT_EQ(MaterialOfCell(claims.Field(), thin.Cell, 0.5), made.Labels[thin.Cell]);
    EXPECT_NE(MaterialOfCell(dust, thin.Cell, 0.5), made.Labels[thin.Cell]);
    EXPECT_GE(thin.Load, dust.Fraction(thin.Cell, made.Labels[thin.Cell]));
  }
}

} // namespace
