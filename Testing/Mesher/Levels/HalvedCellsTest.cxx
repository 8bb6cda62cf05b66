/// Cells that are halved for materials, and their families.
#include "Levels/HalvedCells.h"
#include "Input/NodeCoordinates.h"
#include "Octree/OctreeKeys.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

constexpr std::array<bool, 3> Alone{ { false, false, false } };

CartesianGrid Cube(int cells, double width)
{
  const std::vector<double> nodes = EvenNodes(0.0, width, 0, cells);
  return CartesianGrid(std::array<std::vector<double>, 3>{ { nodes, nodes, nodes } });
}

/// Returns the families of a level.
std::vector<Index3> ListFamilies(
  const std::vector<std::vector<Index>>& families, const CartesianGrid& base, int level)
{
  const OctreeKeys lattice(base, static_cast<int>(families.size()));
  std::vector<Index3> list;
  for (const Index key : families[level])
  {
    list.push_back(lattice.FamilyOfKey(level, key));
  }
  return list;
}

} // namespace

TEST(HalvedCells, HalveWhatContainsANarrowMaterial)
{
  const CartesianGrid grid = Cube(16, 1.0), base = Cube(4, 4.0);
  FractionField fractions(grid, 2);
  fractions.SetLabel(grid.Linear({ { 9, 2, 2 } }), 1);
  fractions.SetParts(grid.Linear({ { 2, 2, 2 } }), { { 2, 0.01 } });
  const HalvedCells halved = FindHalved(grid, fractions, { 0, 2, 1 }, 2);
  int coarse = 0, fine = 0;
  ForCells(halved.Box(0), [&](const Index3& cell) { coarse += halved.Has(0, cell); });
  ForCells(halved.Box(1), [&](const Index3& cell) { fine += halved.Has(1, cell); });
  EXPECT_EQ(coarse, 2);
  EXPECT_EQ(fine, 1);
  EXPECT_TRUE(halved.Has(0, { { 2, 0, 0 } }));
  EXPECT_TRUE(halved.Has(0, { { 0, 0, 0 } })); // contains 1 % of material 2
  EXPECT_TRUE(halved.Has(1, { { 4, 1, 1 } }));

  const auto families = FamiliesOf(halved, base, Alone, 0);
  EXPECT_EQ(
    ListFamilies(families, base, 0), (std::vector<Index3>{ { { 0, 0, 0 } }, { { 1, 0, 0 } } }));
  EXPECT_EQ(ListFamilies(families, base, 1), (std::vector<Index3>{ { { 2, 0, 0 } } }));
  // A layer of cells around reaches the next family, and stays in the domain.
  EXPECT_EQ(FamiliesOf(halved, base, Alone, 1)[1].size(), 8u);
}

TEST(HalvedCells, LayersContinueAcrossPeriodicSides)
{
  const CartesianGrid grid = Cube(16, 1.0), base = Cube(8, 2.0);
  FractionField fractions(grid, 1);
  fractions.SetLabel(grid.Linear({ { 0, 0, 0 } }), 1);
  const HalvedCells halved = FindHalved(grid, fractions, { 0, 1 }, 1);
  EXPECT_EQ(ListFamilies(FamiliesOf(halved, base, Alone, 1), base, 0).size(), 1u);
  EXPECT_EQ(ListFamilies(FamiliesOf(halved, base, { { true, false, false } }, 1), base, 0),
    (std::vector<Index3>{ { { 0, 0, 0 } }, { { 3, 0, 0 } } }));
}
