/// Widths that materials fit, and the choice of cells.
#include "Levels/FitWidths.h"
#include "Input/NodeCoordinates.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Size = 32;
constexpr WidthLimits Limits{ 4.0, 0.5, 3 };

/// Returns 1 in a large ball, 2 in a small one, 3 in a plate of two cells, 0 elsewhere.
int LabelOf(const Index3& cell)
{
  double large = 0.0, small = 0.0;
  for (const Index i : cell)
  {
    large += std::pow(static_cast<double>(i) + 0.5 - 10.0, 2);
    small += std::pow(static_cast<double>(i) + 0.5 - 24.0, 2);
  }
  return large < 81.0 ? 1 : small < 9.0 ? 2 : cell[2] == 30 || cell[2] == 31 ? 3 : 0;
}

struct Choice
{
  std::vector<FittedWidth> Fitted;
  WidthChoice Widths;
};

Choice Choose(const IndexBox& owned, const WidthLimits& limits, Runtime& runtime)
{
  const std::vector<double> nodes = EvenNodes(0.0, 1.0, 0, Size);
  const CartesianGrid grid(GridNodes{ { nodes, nodes, nodes } }, owned, LayersOf(limits));
  FractionField fractions(grid, 3);
  ForCells(grid.Local(),
    [&](const Index3& cell) { fractions.SetLabel(grid.Linear(cell), LabelOf(cell)); });
  const LabelArray labels = AssignMaterials(grid, fractions, 0.5);
  Choice choice;
  choice.Fitted = FitWidths(grid, fractions, labels, limits, 0.5, runtime);
  choice.Widths = ChooseWidths(grid, labels, choice.Fitted, limits, runtime.Group());
  return choice;
}

constexpr IndexBox All{ { { 0, 0, 0 } }, { { Size, Size, Size } } };

} // namespace

TEST(FitWidths, LargeBodiesFitWiderCells)
{
  Runtime serial;
  const std::vector<FittedWidth> fitted = Choose(All, Limits, serial).Fitted;
  EXPECT_GT(fitted[1].Ratio, 3.0);
  EXPECT_LT(fitted[2].Ratio, 2.6); // 8 wider cells would be more than it has
  EXPECT_GE(fitted[2].Ratio, 1.0);
  EXPECT_EQ(fitted[3].Ratio, 4.0); // its side inside moves by nothing
  EXPECT_EQ(fitted[1].Extent.Cells, 3112);
}

TEST(FitWidths, SmallDistancesNeedNarrowCells)
{
  Runtime serial;
  for (const FittedWidth& width : Choose(All, { 4.0, 0.0, 3 }, serial).Fitted)
  {
    EXPECT_TRUE(width.Ratio == 1.0 || width.Extent.Sides == 0 || width.Extent.Distance() == 0.0);
  }
  EXPECT_LT(Choose(All, { 4.0, 0.0, 3 }, serial).Widths.Coarsest, 1.5);
}

TEST(FitWidths, ChoosesCellsThatFitAllMaterials)
{
  Runtime serial;
  const Choice choice = Choose(All, Limits, serial);
  EXPECT_GT(choice.Widths.Coarsest, 1.5);
  for (int m = 1; m <= 3; ++m)
  {
    const double width = std::ldexp(choice.Widths.Coarsest, -choice.Widths.OfMaterial[m]);
    EXPECT_LE(width, choice.Fitted[m].Ratio * (1.0 + 1e-9)) << m;
    EXPECT_LE(choice.Widths.OfMaterial[m], choice.Widths.Halvings) << m;
  }
  const Choice uniform = Choose(All, { 4.0, 0.5, 0 }, serial);
  EXPECT_EQ(uniform.Widths.Halvings, 0);
  EXPECT_LE(uniform.Widths.Coarsest, uniform.Fitted[2].Ratio);
}

TEST(FitWidths, RanksChooseTheSame)
{
  Runtime serial;
  const Choice alone = Choose(All, Limits, serial);
  RunOnRanks(3,
    [&](ThreadRanks& ranks)
    {
      RankRuntime runtime(ranks);
      const Index cuts[] = { 0, 11, 24, Size };
      const Choice choice =
        Choose({ { { 0, cuts[ranks.Rank()], 0 } }, { { Size, cuts[ranks.Rank() + 1], Size } } },
          Limits, runtime);
      EXPECT_EQ(choice.Widths.Coarsest, alone.Widths.Coarsest);
      EXPECT_EQ(choice.Widths.OfMaterial, alone.Widths.OfMaterial);
    });
}
