/// Fractions on other cells of the same domain: every material keeps its volume, equal cells give
/// the same bits, and so do ranks and threads.
#include "Fractions/ResampleFields.h"
#include "Base/ExactSum.h"
#include "Fractions/CoarsenFields.h"
#include "MeshCases.h"
#include "RandomDraw.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Coordinates = std::array<std::vector<double>, 3>;

ResampledFields Resample(
  const CartesianGrid& grid, const FractionField& field, const Coordinates& nodes, Runtime& runtime)
{
  return ResampleFields(grid, field, nodes, 1, runtime);
}

Coordinates NodesOfWidth(const CartesianGrid& grid, const Vector3& width)
{
  Coordinates nodes;
  for (int a = 0; a < 3; ++a)
  {
    nodes[a] = ReplaceNodes(grid.Coordinates(a), width[a]);
  }
  return nodes;
}

/// Returns the volume of each material in the owned cells, from void.
std::vector<double> VolumesOf(const CartesianGrid& grid, const FractionField& field)
{
  std::vector<ExactSum> sums(field.NumberOfMaterials() + 1);
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      field.ForParts(grid.Linear(p),
        [&](int material, double fraction) { sums[material].Add(fraction * grid.CellVolume(p)); });
    });
  std::vector<double> volumes;
  for (const ExactSum& sum : sums)
  {
    volumes.push_back(sum.Value());
  }
  return volumes;
}

Index CountDifferences(
  const ResampledFields& part, const ResampledFields& whole, const IndexBox& cells)
{
  Index different = 0;
  ForCells(cells,
    [&](const Index3& p)
    {
      different +=
        !HaveSameParts(part.Fractions, part.Grid.Linear(p), whole.Fractions, whole.Grid.Linear(p));
    });
  return different;
}

/// Returns labels in blocks of three cells.
FractionField MakeBlocks(const CartesianGrid& grid, int materials)
{
  return MakeLabels(grid, materials,
    [&](const Index3& p)
    { return static_cast<int>((p[0] / 3 + 2 * (p[1] / 3) + 5 * (p[2] / 3)) % (materials + 1)); });
}

} // namespace

TEST(ResampleFields, EveryMaterialKeepsItsVolume)
{
  Runtime runtime;
  RandomDraw draw(5);
  double largest = 0.0;
  for (int round = 0; round < 24; ++round)
  {
    const CartesianGrid grid = round % 2 ? MakeUnevenGrid(17) : MakeUnitGrid(19, 16, 13);
    const int materials = draw.Whole(1, 5);
    const FractionField field =
      round % 3 ? MakePatchyFractions(grid, materials, round) : MakeBlocks(grid, materials);
    const ResampledFields coarse =
      Resample(grid, field, NodesOfWidth(grid, draw.Vector(0.4, round < 12 ? 4.0 : 30.0)), runtime);
    EXPECT_EQ(coarse.Grid.Coordinates(0).back(), grid.Coordinates(0).back());
    const std::vector<double> before = VolumesOf(grid, field);
    const std::vector<double> after = VolumesOf(coarse.Grid, coarse.Fractions);
    for (std::size_t m = 0; m < before.size(); ++m)
    {
      largest = std::max(largest, std::fabs(after[m] - before[m]) / std::max(before[m], 1e-300));
    }
  }
  std::printf("volumes before and after differ by at most %.1e\n", largest);
  EXPECT_LT(largest, 1e-15);
}

TEST(ResampleFields, FractionsAreSharesOfOverlaps)
{
  Runtime runtime;
  const CartesianGrid grid = MakeUnitGrid(5, 5, 5);
  const FractionField field =
    MakeLabels(grid, 2, [](const Index3& p) { return p[0] < 3 ? 1
                                                : p[1] < 1    ? 0
                                                              : 2; });
  const ResampledFields coarse =
    Resample(grid, field, NodesOfWidth(grid, { { 2.5, 2.5, 5.0 } }), runtime);
  ASSERT_EQ(coarse.Grid.Global(), (IndexBox{ {}, { { 2, 2, 1 } } }));
  const auto fraction = [&](Index i, Index j, int material) {
    return coarse.Fractions.Fraction(coarse.Grid.Linear({ { i, j, 0 } }), material);
  };
  EXPECT_FALSE(coarse.Fractions.IsMixed(coarse.Grid.Linear({ { 0, 0, 0 } })));
  EXPECT_EQ(fraction(0, 0, 1), 1.0);
  EXPECT_DOUBLE_EQ(fraction(1, 0, 1), 0.2);
  EXPECT_DOUBLE_EQ(fraction(1, 0, 0), 0.8 * 0.4);
  EXPECT_DOUBLE_EQ(fraction(1, 0, 2), 0.8 * 0.6);
  EXPECT_EQ(fraction(1, 1, 0), 0.0);
}

TEST(ResampleFields, EqualCellsGiveTheSameBits)
{
  Runtime runtime;
  for (int materials = 1; materials <= 4; ++materials)
  {
    const CartesianGrid grid = materials % 2 ? MakeUnevenGrid(9) : MakeUnitGrid(9, 7, 8);
    const FractionField field = MakePatchyFractions(grid, materials, materials);
    const ResampledFields same = Resample(grid, field, grid.Coordinates(), runtime);
    EXPECT_EQ(CountDifferences({ grid, field }, same, grid.Owned()), 0);
  }
}

TEST(ResampleFields, PairsOfCellsAreThoseOfCoarsenFields)
{
  ThreadedRuntime runtime;
  const CartesianGrid grid = MakeUnitGrid(12, 8, 6);
  const FractionField field = MakePatchyFractions(grid, 3, 8);
  const ResampledFields pairs = Resample(grid, field, NodesOfWidth(grid, { { 2, 2, 2 } }), runtime);
  const CartesianGrid coarse = CoarsenGrid(grid, 1, 0);
  const FractionField means = CoarsenFractions(grid, field, 1, coarse, runtime);
  EXPECT_EQ(pairs.Grid.Coordinates(), coarse.Coordinates());
  ForCells(coarse.Owned(),
    [&](const Index3& p)
    {
      const Index one = pairs.Grid.Linear(p), other = coarse.Linear(p);
      ASSERT_EQ(pairs.Fractions.IsMixed(one), means.IsMixed(other));
      for (int m = 0; m <= 3; ++m)
      {
        EXPECT_NEAR(pairs.Fractions.Fraction(one, m), means.Fraction(other, m), 1e-15);
      }
    });
}

TEST(ResampleFields, RanksHoldWhatTheWholeGridHolds)
{
  for (double width : { 1.0, 1.7, 2.0, 3.3, 9.0, 40.0 })
  {
    const CartesianGrid whole = MakeUnevenGrid(21);
    const FractionField field =
      width < 3.0 ? MakePatchyFractions(whole, 3, 7) : MakeBlocks(whole, 3);
    const Coordinates nodes = NodesOfWidth(whole, { { width, width, 1.5 * width } });
    ThreadedRuntime threads;
    const ResampledFields all = Resample(whole, field, nodes, threads);
    for (int count : { 2, 3, 8 })
    {
      std::vector<IndexBox> boxes = CutBox(whole.Global(), count);
      boxes.push_back(IndexBox()); // a rank without cells
      std::atomic<Index> differences{ 0 }, owned{ 0 };
      RunOnRanks(static_cast<int>(boxes.size()),
        [&](Ranks& ranks)
        {
          RankRuntime runtime(ranks);
          const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
          const ResampledFields part =
            Resample(grid, CopyToLocal(whole, field, grid), nodes, runtime);
          owned += part.Grid.Owned().NumberOfCells();
          differences += CountDifferences(part, all, part.Grid.Local());
        });
      EXPECT_EQ(owned, all.Grid.Global().NumberOfCells()) << count << " ranks, width " << width;
      EXPECT_EQ(differences, 0) << count << " ranks, width " << width;
    }
  }
}

/// Ranks own whole blocks, so that cells can be joined in pairs later.
TEST(ResampleFields, RanksOwnWholeBlocks)
{
  const CartesianGrid whole = MakeUnitGrid(40, 30, 30);
  const Coordinates nodes = NodesOfWidth(whole, { { 1.3, 1.5, 2.0 } });
  const IndexBox cells{ {}, { { 31, 20, 15 } } };
  for (Index block : { 1, 2, 4, 8 })
  {
    Index sum = 0;
    for (const IndexBox& owned : CutBox(whole.Global(), 7))
    {
      const IndexBox own = CellsOfOwner(whole.Coordinates(), nodes, block, owned);
      sum += own.NumberOfCells();
      for (int a = 0; a < 3; ++a)
      {
        EXPECT_EQ(own.Lower[a] % block, 0);
        EXPECT_TRUE(own.Upper[a] % block == 0 || own.Upper[a] == cells.Upper[a]);
      }
    }
    EXPECT_EQ(sum, cells.NumberOfCells());
  }
}
