/// Meshes follow their cells: they have the same fragments, and the same pairs of fragments touch.
/// No element has all points on interfaces or sides of the domain.
#include "Labels/SmoothLabels.h"
#include "MeshCases.h"
#include "OverlapChecks.h"
#include "RandomDraw.h"
#include "RankMeshes.h"
#include "Sweep.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Cells = 8; // cells of the grids of random fields per axis
constexpr int Smoothings[] = { 0, 1, 3, 10 };

enum class Field
{
  Labels,      // a random label in each cell
  NoisyBlocks, // a random label in each 2 x 2 x 2 block, another one in 5 % of the cells
  Fractions    // random fractions
};

struct Case
{
  Field Kind;
  int Refinements;
};

void PrintTo(const Case& c, std::ostream* out)
{
  *out << "field " << static_cast<int>(c.Kind) << ", " << c.Refinements << " refinements";
}

FractionField MakeNoisyBlocks(const CartesianGrid& grid, int materials, unsigned seed)
{
  RandomDraw draw(seed);
  std::vector<int> blocks;
  for (Index b = 0; b < Cells * Cells * Cells / 8; ++b)
  {
    blocks.push_back(draw.Whole(0, materials));
  }
  return MakeLabels(grid, materials,
    [&](const Index3& p)
    {
      const Index block = ((p[2] / 2) * Cells / 2 + p[1] / 2) * Cells / 2 + p[0] / 2;
      return draw.Chance(0.05) ? draw.Whole(0, materials) : blocks[block];
    });
}

FractionField MakeNoise(const CartesianGrid& grid, int materials, unsigned seed)
{
  RandomDraw draw(seed);
  FractionField field(grid, materials);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      std::vector<FractionField::Part> parts;
      double sum = draw.Between(0.0, 1.0); // void
      for (int m = 1; m <= materials; ++m)
      {
        parts.push_back({ m, draw.Between(0.0, 1.0) });
        sum += parts.back().Fraction;
      }
      std::for_each(parts.begin(), parts.end(), [&](auto& part) { part.Fraction /= sum; });
      field.SetParts(grid.Linear(p), parts);
    });
  return field;
}

FractionField MakeField(Field kind, const CartesianGrid& grid, unsigned seed)
{
  const int materials = 2 + static_cast<int>(seed % 4);
  return kind == Field::Labels ? MakeRandomLabels(grid, materials, 0, seed)
    : kind == Field::Fractions ? MakeNoise(grid, materials, seed)
                               : MakeNoisyBlocks(grid, materials, seed);
}

void Smooth(const CartesianGrid& grid, int passes, FractionField& field)
{
  Runtime runtime;
  if (passes > 0)
  {
    SmoothLabels(grid, passes, Partition(grid, runtime.Group()), runtime, field);
  }
}

void ExpectCells(
  const CartesianGrid& grid, const FractionField& field, const MeshOptions& options, MeshMaker make)
{
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = make(grid, field, options, runtime, report);
  EXPECT_EQ(FindCellProblem(grid, mesh, MakeCells(grid, field, options)), "");
  EXPECT_EQ(FindTopologyProblem(mesh), "");
  EXPECT_EQ(CountLocked(mesh), 0);
  EXPECT_EQ(FindElementOverlaps(mesh).Pairs, 0);
  EXPECT_EQ(CountCoincidentPoints(mesh), 0);
  EXPECT_GT(SmallestCornerDeterminant(mesh), 0.0);
}

/// Two plates with a gap, or one plate if their labels are equal.
struct Gap
{
  double Width, Slope; // cells; rise per cell
  int Upper;           // label of the upper plate; the lower one has 1
};

FractionField MakePlates(const CartesianGrid& grid, const Gap& gap)
{
  const double middle = gap.Width == 2.0 ? 8.0 : 8.5; // symmetric about cells
  return MakeLabels(grid, 2,
    [&](const Index3& p)
    {
      const double height = p[2] + 0.5 - middle - gap.Slope * (p[0] - 7.5);
      const bool isInside = p[0] > 1 && p[0] < 14 && p[1] > 1 && p[1] < 14 &&
        std::abs(height) > gap.Width / 2 && std::abs(height) < 4.5;
      return !isInside ? 0 : height > 0.0 ? gap.Upper : 1;
    });
}

class FollowsCells : public ::testing::TestWithParam<Case>
{
};

} // namespace

TEST_P(FollowsCells, RandomFields)
{
  const Case& c = this->GetParam();
  const CartesianGrid grid = MakeUnitGrid(Cells);
  for (unsigned seed : ListSeeds(4))
  {
    for (int passes : Smoothings)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", smoothing " + std::to_string(passes));
      FractionField field = MakeField(c.Kind, grid, seed);
      Smooth(grid, passes, field);
      MeshOptions options;
      options.MeshVoid = seed % 4 == 3;
      options.Levels.Refinements = c.Refinements;
      options.Levels.FineInterfaces = true;
      ExpectCells(grid, field, options, MakeTetMesh);
      CompareWithSerial(grid, field, { CutBaseBox(grid, c.Refinements, 3) }, options, MakeTetMesh);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fields, FollowsCells,
  ::testing::Values(Case{ Field::Labels, 0 }, Case{ Field::NoisyBlocks, 0 },
    Case{ Field::Fractions, 0 }, Case{ Field::NoisyBlocks, 1 }));

TEST(FollowsCells, PlatesWithGaps)
{
  const CartesianGrid grid = MakeUnitGrid(16);
  for (const Gap& gap :
    { Gap{ 1.0, 0.0, 2 }, Gap{ 1.0, 0.0, 1 }, Gap{ 1.3, 0.3, 2 }, Gap{ 2.0, 0.0, 2 } })
  {
    for (int passes : Smoothings)
    {
      SCOPED_TRACE("gap " + std::to_string(gap.Width) + ", label " + std::to_string(gap.Upper) +
        ", smoothing " + std::to_string(passes));
      FractionField field = MakePlates(grid, gap);
      Smooth(grid, passes, field);
      MeshOptions options;
      ExpectCells(grid, field, options, MakeHexMesh);
      ExpectCells(grid, field, options, MakeTetMesh);
      options.Method = TetMethod::Cells;
      ExpectCells(grid, field, options, MakeTetMesh);
    }
  }
}
