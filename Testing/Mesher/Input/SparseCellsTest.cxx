/// Cells in messages.
#include "Input/SparseCells.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;

TEST(SparseCells, MessagesKeepAllValues)
{
  struct Item
  {
    int Material;
    double Value;
  };
  SparseCells cells;
  cells.Box = { { { 2, 3, 4 } }, { { 4, 4, 6 } } };
  cells.AddCell(std::vector<Item>{});
  cells.AddCell(std::vector<Item>{ { 7, 1.0 } });
  cells.AddCell(std::vector<Item>{ { 1, 0.25 }, { 4, -3.0 } });
  cells.AddCell(std::vector<Item>{ { 2, std::nan("") } });
  const std::vector<SparseCells> got = UnpackCells(PackCells({ cells, SparseCells(), cells }));
  ASSERT_EQ(got.size(), 3u);
  EXPECT_EQ(got[1].Box, IndexBox());
  for (int i : { 0, 2 })
  {
    EXPECT_EQ(got[i].Box, cells.Box);
    EXPECT_FALSE(got[i].IsListed(0));
    EXPECT_EQ(got[i].Fraction(0, 7), 0.0);
    EXPECT_EQ(got[i].Fraction(1, 7), 1.0);
    EXPECT_EQ(got[i].Fraction(1, 1), 0.0);
    EXPECT_TRUE(got[i].IsListed(2));
    EXPECT_EQ(got[i].Fraction(2, 1), 0.25);
    EXPECT_EQ(got[i].Fraction(2, 4), -3.0);
    EXPECT_EQ(got[i].Fraction(2, 2), 0.0);
    EXPECT_TRUE(std::isnan(got[i].Fraction(3, 2)));
  }
  EXPECT_TRUE(UnpackCells(PackCells({})).empty());
}
