/// Numbers of cells and halvings for widths of materials.
#include "Levels/CellSizes.h"
#include "Input/NodeCoordinates.h"
#include "Ranks/Errors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;

namespace
{

constexpr double Other = HUGE_VAL; // no width of its own
constexpr std::array<bool, 3> Alone{ { false, false, false } };

std::vector<double> Nodes(int cells, double width)
{
  return EvenNodes(0.0, width, 0, cells);
}

GridNodes Cube(int cells)
{
  return { { Nodes(cells, 1.0), Nodes(cells, 1.0), Nodes(cells, 1.0) } };
}

} // namespace

TEST(CellSizes, HalveUntilTheSmallestWidth)
{
  const CellSizes sizes =
    PlanSizes(Cube(48), { { 4.0, 4.0, 4.0 } }, { Other, Other, 2.0, 1.0, 3.0 }, Alone);
  EXPECT_EQ(sizes.Halvings, 2);
  EXPECT_EQ(sizes.OfMaterial, (std::vector<int>{ 0, 0, 1, 2, 1 }));
  EXPECT_EQ(sizes.Nodes, Cube(48)); // bit by bit
}

TEST(CellSizes, CoarsestCellsFillTheDomain)
{
  const CellSizes sizes = PlanSizes(Cube(91), { { 4.0, 4.0, 4.0 } }, { Other, 1.0, Other }, Alone);
  EXPECT_EQ(sizes.Halvings, 2);
  EXPECT_EQ(sizes.Nodes[0].size(), 89u); // 22 coarsest cells, not 23: none is below 1
  EXPECT_EQ(sizes.Nodes[0].back(), 91.0);
  EXPECT_NEAR(MeanWidths(sizes.Nodes)[1], 91.0 / 88.0, 1e-12);
}

TEST(CellSizes, WidestWidthLimitsTheCoarsestCells)
{
  // Halving 3 gives 1.5 and 0.75, so the coarsest cells have 2.
  const CellSizes sizes = PlanSizes(Cube(48), { { 3.0, 3.0, 3.0 } }, { Other, 1.0, Other }, Alone);
  EXPECT_EQ(sizes.Halvings, 1);
  EXPECT_EQ(sizes.OfMaterial, (std::vector<int>{ 0, 1, 0 }));
  EXPECT_EQ(sizes.Nodes[2].size(), 49u);
  // Without CellWidth all others have the cells of the input.
  const CellSizes wide = PlanSizes(Cube(48), {}, { Other, 4.0, Other }, Alone);
  EXPECT_EQ(wide.Halvings, 2);
  EXPECT_EQ(wide.OfMaterial, (std::vector<int>{ 0, 0, 2 }));
  // Void with a width counts like a material.
  EXPECT_EQ(PlanSizes(Cube(48), {}, { 4.0, Other }, Alone).OfMaterial, (std::vector<int>{ 0, 2 }));
}

/// Few coarsest cells along an axis would make the finest ones too wide.
TEST(CellSizes, ThinDomainsHaveFewerHalvings)
{
  const GridNodes layer{ { Nodes(48, 1.0), Nodes(48, 1.0), Nodes(7, 1.0) } };
  const CellSizes sizes = PlanSizes(layer, { { 8.0, 8.0, 8.0 } }, { Other, 1.0, Other }, Alone);
  EXPECT_EQ(sizes.Halvings, 1); // 4 cells of 7/4 with 2, 6 of 7/6 with 1
  EXPECT_EQ(sizes.OfMaterial, (std::vector<int>{ 0, 1, 0 }));
  EXPECT_EQ(sizes.Nodes[2].size(), 7u);
  EXPECT_EQ(LimitHalvings(Cube(24), { { 1.0, 1.0, 1.0 } }, 9, Alone), 3); // not 16 cells of 3/2
}

TEST(CellSizes, SlicesKeepTheirProportions)
{
  const GridNodes slices{ { Nodes(48, 1.0), Nodes(48, 1.0), Nodes(16, 3.0) } };
  const CellSizes sizes = PlanSizes(slices, {}, { Other, 2.0, 1.0 }, Alone);
  EXPECT_EQ(sizes.Halvings, 1);
  EXPECT_EQ(sizes.Nodes, slices);
}

TEST(CellSizes, NarrowerThanTheInputIsAnError)
{
  try
  {
    PlanSizes(Cube(48), { { 4.0, 4.0, 4.0 } }, { Other, 0.5 }, Alone);
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("Refinement"), std::string::npos) << error.what();
  }
  try
  {
    const GridNodes slices{ { Nodes(48, 1.0), Nodes(48, 1.0), Nodes(16, 3.0) } };
    PlanSizes(slices, { { 4.0, 4.0, 4.0 } }, { Other, 1.0 }, Alone);
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("width 1 along z, and those of the input are 3 wide"),
      std::string::npos)
      << error.what();
  }
}

TEST(CellSizes, PeriodicAxesHaveAnEvenNumberOfCoarsestCells)
{
  const std::array<bool, 3> repeats{ { true, false, false } };
  const CellSizes sizes =
    PlanSizes(Cube(20), { { 4.0, 4.0, 4.0 } }, { Other, 1.0, Other }, repeats);
  EXPECT_EQ(sizes.Halvings, 2);
  EXPECT_EQ(sizes.Nodes[0].size(), 17u); // 4 cells, each halved twice
  EXPECT_EQ(sizes.Nodes[1].size(), 21u);
  EXPECT_EQ(CountDoublings(Cube(20), Alone), 4);
  EXPECT_EQ(CountDoublings(Cube(20), repeats), 2);
  EXPECT_EQ(CountDoublings({ { Nodes(20, 1.0), Nodes(20, 1.0), Nodes(1, 1.0) } }, Alone), 0);
}
