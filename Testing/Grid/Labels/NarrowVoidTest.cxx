/// Narrow void: which cells are narrow, and that bodies on both sides do not overlap.
#include "Labels/NarrowVoid.h"

#include "Base/ThreadRuntime.h"
#include "Labels/SmoothLabels.h"
#include "MeshCases.h"
#include "MeshChecks.h"
#include "OverlapChecks.h"
#include "Phases/MeshOfCells.h"
#include "RankMeshes.h"
#include "Sweep.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using LabelOf = std::function<int(const Index3&)>;

/// Returns the number of narrow cells of labels of void and two materials.
Index CountNarrow(const CartesianGrid& grid, const LabelOf& label)
{
  Runtime runtime;
  const LabelArray labels = AssignMaterials(grid, MakeLabels(grid, 2, label), 0.5);
  const RefinedGrid levels(grid, runtime.Group());
  const NarrowVoid narrow(levels, labels, FindMixedNodes(grid, labels), runtime);
  Index count = 0;
  ForCells(grid.Global(), [&](const Index3& cell) { count += narrow.Has(grid.Linear(cell)); });
  EXPECT_EQ(count, narrow.CountOwned());
  EXPECT_EQ(count == 0, narrow.IsEmpty());
  return count;
}

/// Returns label of two plates of 16 x 16 x 6 cells with a gap between them.
int LabelOfPlates(const Index3& p, Index gap)
{
  const bool isBeside = p[0] < 4 || p[0] >= 20 || p[1] < 4 || p[1] >= 20;
  const bool isLower = p[2] >= 6 && p[2] < 12, isUpper = p[2] >= 12 + gap && p[2] < 18 + gap;
  return isBeside ? 0 : (isLower ? 1 : (isUpper ? 2 : 0));
}

FractionField MakePlates(const CartesianGrid& grid, int passes)
{
  FractionField fractions =
    MakeLabels(grid, 2, [](const Index3& p) { return LabelOfPlates(p, 1); });
  if (passes > 0)
  {
    Runtime runtime;
    SmoothLabels(grid, passes, Partition(grid, runtime.Group()), runtime, fractions);
  }
  return fractions;
}

std::vector<ElementMaker> ListMethods()
{
  std::vector<ElementMaker> methods(std::begin(ElementMakers), std::end(ElementMakers));
  if (HasTetGen())
  {
    methods.push_back({ "TetGen", MakeTetMesh, TetMethod::TetGen });
  }
  return methods;
}

struct Made
{
  Mesh Elements;
  MeshReport Report;
};

Made MakeMesh(const CartesianGrid& grid, const FractionField& fractions, const ElementMaker& method,
  MeshOptions options = {})
{
  options.Method = method.Tets;
  Runtime runtime;
  Made made;
  made.Elements = method.Make(grid, fractions, options, runtime, made.Report);
  return made;
}

/// Returns whether the mesh has only elements of materials, and no points besides theirs.
bool HasOnlyMaterials(const Mesh& mesh)
{
  std::vector<unsigned char> isUsed(mesh.PointIds.size(), 0);
  for (Index point : mesh.Elements)
  {
    isUsed[point] = 1;
  }
  return std::find(isUsed.begin(), isUsed.end(), 0) == isUsed.end() &&
    std::all_of(mesh.Material.begin(), mesh.Material.end(), [](int m) { return m > 0; }) &&
    std::all_of(mesh.Fragment.begin(), mesh.Fragment.end(), [](int f) { return f > 0; });
}

} // namespace

TEST(NarrowVoid, IsBetweenPlatesUpToThreeCellsApart)
{
  const CartesianGrid grid = MakeUnitGrid(24);
  const Index layers[5] = { 0, 1, 2, 1, 0 }; // of three layers of void, only the middle one
  for (Index gap = 1; gap <= 4; ++gap)
  {
    EXPECT_EQ(
      CountNarrow(grid, [&](const Index3& p) { return LabelOfPlates(p, gap); }), 256 * layers[gap])
      << gap;
  }
}

TEST(NarrowVoid, IsNotAroundOneSmoothBody)
{
  const CartesianGrid grid = MakeUnitGrid(24);
  for (double radius : { 3.0, 5.5, 8.0, 9.5 })
  {
    EXPECT_EQ(CountNarrow(grid,
                [&](const Index3& p)
                {
                  double square = 0.0;
                  for (int a = 0; a < 3; ++a)
                  {
                    square += (p[a] - 11.8 - 0.1 * a) * (p[a] - 11.8 - 0.1 * a);
                  }
                  return square < radius * radius ? 1 : 0;
                }),
      0)
      << radius;
  }
}

TEST(NarrowVoid, IsBetweenSeparatePartsAndBesideSeveralMaterials)
{
  const CartesianGrid grid = MakeUnitGrid(7);
  // Two cells, in directions at 135 degrees from the middle one.
  EXPECT_EQ(CountNarrow(grid,
              [](const Index3& p)
              {
                const bool isBelow = p == Index3{ { 2, 1, 2 } };
                return isBelow || p == Index3{ { 2, 3, 3 } } ? 1 : 0;
              }),
    2);
  // A step at the edge of a block, of one material or two.
  const auto label = [](const Index3& p, int other)
  {
    const bool isInside = p[0] > 0 && p[1] > 0 && p[2] > 0 && p[0] < 5 && p[1] < 5 && p[2] < 4;
    return isInside && p[0] + p[1] > 2 ? (p[0] > 1 ? 1 : other) : 0;
  };
  EXPECT_EQ(CountNarrow(grid, [&](const Index3& p) { return label(p, 1); }), 0);
  EXPECT_EQ(CountNarrow(grid, [&](const Index3& p) { return label(p, 2); }), 3);
}

TEST(NarrowVoid, IsInPocketsAtSidesOfTheDomain)
{
  const CartesianGrid grid = MakeUnitGrid(6);
  EXPECT_EQ(CountNarrow(grid, [](const Index3& p) { return p[0] < 3 || p[2] > 0 ? 1 : 0; }), 6);
  EXPECT_EQ(CountNarrow(grid, [](const Index3& p) { return p[2] > 0 ? 1 : 0; }), 0);
}

TEST(NarrowVoid, IsTheSameOnAnyRanks)
{
  const CartesianGrid whole = MakeUnitGrid(14, 12, 13);
  const FractionField fractions = MakeRandomLabels(whole, 2, 0, 5);
  const auto listCells = [&](const CartesianGrid& grid, Ranks& ranks)
  {
    const LabelArray labels = AssignMaterials(grid, CopyToLocal(whole, fractions, grid), 0.5);
    const RefinedGrid levels(grid, ranks);
    ThreadRuntime runtime(2, &ranks);
    const NarrowVoid narrow(levels, labels, FindMixedNodes(grid, labels), runtime);
    std::vector<Index> cells;
    ForCells(Grow(grid.HexBox(), 1, grid.Global()),
      [&](const Index3& cell)
      {
        if (narrow.Has(grid.Linear(cell)))
        {
          cells.push_back(grid.CellKey(cell));
        }
      });
    return cells;
  };
  Ranks alone;
  const std::vector<Index> all = listCells(whole, alone);
  ASSERT_GT(all.size(), 100u);
  const std::vector<IndexBox> boxes = CutBox(whole.Owned(), 4);
  RunOnRanks(4,
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
      const IndexBox known = Grow(grid.HexBox(), 1, grid.Global());
      std::vector<Index> expected;
      std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
        [&](Index key) { return known.Contains(whole.CellOfKey(key)); });
      EXPECT_EQ(listCells(grid, ranks), expected);
    });
}

/// Without a barrier, smoothing makes these plates overlap, by 0.18 to 0.24 widths of an element.
TEST(NarrowVoid, KeepsPlatesApart)
{
  const CartesianGrid grid = MakeUnitGrid(24);
  const FractionField plates = MakePlates(grid, 3);
  for (const ElementMaker& method : ListMethods())
  {
    const Made made = MakeMesh(grid, plates, method);
    EXPECT_EQ(FindElementOverlaps(made.Elements).Depth, 0.0) << method.Name;
    EXPECT_TRUE(HasOnlyMaterials(made.Elements)) << method.Name;
    EXPECT_EQ(made.Report.NumberOfFragments, 2) << method.Name;
    EXPECT_EQ(made.Report.NarrowVoidCells, 256) << method.Name;
    for (int m = 1; m <= 2; ++m)
    {
      EXPECT_NEAR(made.Report.MeshVolume[m], made.Report.TargetVolume[m], 1e-3) << method.Name;
    }
  }
}

/// The barrier hardly pulls: without label smoothing, nothing has to be kept apart.
TEST(NarrowVoid, LowersQualityLittle)
{
  const CartesianGrid grid = MakeUnitGrid(24);
  const FractionField plates = MakePlates(grid, 0);
  EXPECT_GT(MakeMesh(grid, plates, ListMethods()[0]).Report.MinimumScaledJacobian, 0.71);
  const MeshReport lattice = MakeMesh(grid, plates, ListMethods()[1]).Report;
  EXPECT_GT(lattice.MinimumDihedralAngle, 42.0);
  EXPECT_LT(lattice.MaximumDihedralAngle, 113.5);
}

TEST(NarrowVoid, HasNoElementsWhereNothingMoves)
{
  const CartesianGrid grid = MakeUnitGrid(24);
  const FractionField plates = MakePlates(grid, 0);
  MeshOptions meshed, stairs, unsmoothed;
  meshed.MeshVoid = stairs.StairStep = true;
  unsmoothed.Smoothing = SmoothingMethod::Off;
  for (const ElementMaker& method : ListMethods())
  {
    for (const MeshOptions& options : { meshed, stairs, unsmoothed })
    {
      EXPECT_EQ(MakeMesh(grid, plates, method, options).Report.NarrowVoidCells, 0) << method.Name;
    }
  }
}

TEST(NarrowVoid, KeepsRandomLabelsApart)
{
  for (const ElementMaker& method : ListMethods())
  {
    for (unsigned seed : ListSeeds(6))
    {
      const Index n = 4 + seed % 4;
      const CartesianGrid grid = MakeUnitGrid(n, n + 1, n);
      MeshOptions options;
      options.SharpEdges = seed % 2 == 0 ? SharpEdgeMode::On : SharpEdgeMode::Off;
      const Made made = MakeMesh(grid, MakeRandomLabels(grid, 2, 0, seed), method, options);
      EXPECT_EQ(FindElementOverlaps(made.Elements).Depth, 0.0) << method.Name << ", seed " << seed;
      EXPECT_TRUE(HasOnlyMaterials(made.Elements)) << method.Name << ", seed " << seed;
      EXPECT_GT(made.Report.NarrowVoidCells, 0) << method.Name << ", seed " << seed;
    }
  }
}

/// Points beside narrow void move so far that parts of one body overlap in a notch; then points go
/// back to their start (Intersections.h). Without that, two pairs of hexes overlap in each mesh.
TEST(NarrowVoid, IsNotCrossedInNotches)
{
  const CartesianGrid grid = MakeUnitGrid(8);
  for (unsigned seed : { 26, 29 })
  {
    const FractionField labels = MakeRandomLabels(grid, 1, 0, seed);
    const Made made = MakeMesh(grid, labels, ListMethods()[0]);
    EXPECT_EQ(FindElementOverlaps(made.Elements).Pairs, 0) << seed;
    EXPECT_EQ(CountCoincidentPoints(made.Elements), 0) << seed;
    EXPECT_GT(made.Report.MinimumScaledJacobian, 0.3) << seed;
    EXPECT_NEAR(made.Report.MeshVolume[1] / made.Report.TargetVolume[1], 1.0, 1e-6) << seed;
    CompareWithSerial(grid, labels, { CutBox(grid.Owned(), 8) }, MeshOptions());
  }
}

TEST(NarrowVoid, KeepsBodiesApartOnRanks)
{
  const CartesianGrid grid = MakeUnitGrid(24);
  const FractionField plates = MakePlates(grid, 3);
  for (const ElementMaker& method : ListMethods())
  {
    MeshOptions options;
    options.Method = method.Tets;
    if (method.Tets != TetMethod::TetGen) // its elements depend on the ranks
    {
      CompareWithSerial(grid, plates, { CutBox(grid.Owned(), 3, 2), CutBox(grid.Owned(), 8) },
        options, method.Make);
    }
  }
}

/// Interfaces through cells of two levels: void between bodies has coarse hexes too.
TEST(NarrowVoid, HasCoarseHexesWhereInterfacesCrossLevels)
{
  const CartesianGrid grid = MakeUnitGrid(32);
  FractionField plates = MakeLabels(grid, 2,
    [](const Index3& p)
    {
      const bool isBeside = p[0] < 4 || p[0] >= 28 || p[1] < 4 || p[1] >= 28;
      return isBeside ? 0 : (p[2] >= 4 && p[2] < 14 ? 1 : (p[2] >= 16 && p[2] < 26 ? 2 : 0));
    });
  Runtime runtime;
  SmoothLabels(grid, 8, Partition(grid, runtime.Group()), runtime, plates);
  MeshOptions options;
  options.Levels.Refinements = 1;
  options.Levels.FineInterfaces = false;
  const Made made = MakeMesh(grid, plates, ListMethods()[0], options);
  EXPECT_EQ(made.Report.NarrowVoidCells, 24 * 24 * 2);
  EXPECT_EQ(FindElementOverlaps(made.Elements).Depth, 0.0);
  EXPECT_TRUE(HasOnlyMaterials(made.Elements));
}
