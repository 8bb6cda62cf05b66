/// Labels that wider cells give to the cells of the input: exact counts on slabs, balls and ranks.
#include "Levels/MaterialFits.h"
#include "Input/NodeCoordinates.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

std::array<std::vector<double>, 3> Cube(int cells, double length)
{
  const std::vector<double> nodes = EvenNodes(0.0, length / cells, 0, cells);
  return { { nodes, nodes, nodes } };
}

/// Compares labels of 24^3 cells with wider cells.
/// @param labelOf labelOf(cell)
template <class LabelOf>
std::vector<MaterialFit> Compare(
  const IndexBox& owned, int wider, const LabelOf& labelOf, Runtime& runtime)
{
  const CartesianGrid grid(Cube(24, 24.0), owned, 12);
  FractionField fractions(grid, 2);
  ForCells(grid.Local(),
    [&](const Index3& cell) { fractions.SetLabel(grid.Linear(cell), labelOf(cell)); });
  return FindFits(
    grid, fractions, AssignMaterials(grid, fractions, 0.5), Cube(wider, 24.0), 0.5, runtime);
}

constexpr IndexBox All{ { { 0, 0, 0 } }, { { 24, 24, 24 } } };

int SlabLabel(const Index3& cell)
{
  return cell[0] < 9 ? 1 : 2;
}

int BallLabel(const Index3& cell)
{
  double squares = 0.0;
  for (const Index i : cell)
  {
    squares += std::pow(static_cast<double>(i) + 0.5 - 11.3, 2);
  }
  return squares < 64.0 ? 1 : 0;
}

} // namespace

/// The plane of the slab is in the middle of cells of 2, and on a side of cells of 3.
TEST(MaterialFits, PlanesStay)
{
  Runtime serial;
  for (const int wider : { 12, 8 })
  {
    const std::vector<MaterialFit> fits = Compare(All, wider, SlabLabel, serial);
    EXPECT_EQ(fits[1].Cells, 9 * 24 * 24);
    EXPECT_EQ(fits[1].Lost, 0) << wider;
    EXPECT_EQ(fits[1].Gained, 0) << wider;
    EXPECT_EQ(fits[1].Sides, 24 * 24);
    EXPECT_EQ(fits[2].Sides, 24 * 24);
    EXPECT_EQ(fits[0].Cells, 0);
    EXPECT_EQ(fits[1].Distance(), 0.0);
  }
}

TEST(MaterialFits, ThinMaterialsAreLost)
{
  Runtime serial;
  const auto plate = [](const Index3& cell) { return cell[1] == 10 ? 1 : 2; };
  const std::vector<MaterialFit> fits = Compare(All, 8, plate, serial); // a third of cells of 3
  EXPECT_EQ(fits[1].Cells, 24 * 24);
  EXPECT_EQ(fits[1].Lost, 24 * 24);
  EXPECT_EQ(fits[2].Gained, 24 * 24);
  EXPECT_EQ(fits[1].Sides, 2 * 24 * 24);
  EXPECT_DOUBLE_EQ(fits[1].Distance(), 0.75); // half of a cell, by 3/2
}

TEST(MaterialFits, BallsMoveMoreInWiderCells)
{
  Runtime serial;
  const double two = Compare(All, 12, BallLabel, serial)[1].Distance();
  const double four = Compare(All, 6, BallLabel, serial)[1].Distance();
  EXPECT_GT(two, 0.02);
  EXPECT_LT(two, 0.3);
  EXPECT_GT(four, 1.5 * two);
}

TEST(MaterialFits, RanksFindTheSame)
{
  Runtime serial;
  const std::vector<MaterialFit> alone = Compare(All, 7, BallLabel, serial);
  RunOnRanks(3,
    [&](ThreadRanks& ranks)
    {
      RankRuntime runtime(ranks);
      const Index cuts[] = { 0, 5, 17, 24 };
      const IndexBox owned{ { { 0, 0, cuts[ranks.Rank()] } },
        { { 24, 24, cuts[ranks.Rank() + 1] } } };
      const std::vector<MaterialFit> fits = Compare(owned, 7, BallLabel, runtime);
      for (int m = 0; m < 3; ++m)
      {
        EXPECT_EQ(fits[m].Lost, alone[m].Lost);
        EXPECT_EQ(fits[m].Gained, alone[m].Gained);
        EXPECT_EQ(fits[m].Sides, alone[m].Sides);
      }
    });
}
