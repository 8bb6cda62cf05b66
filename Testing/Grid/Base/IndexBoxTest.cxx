/// Boxes of cells.
#include "Base/IndexBox.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

const IndexBox Box{ { { 1, 1, 1 } }, { { 3, 4, 5 } } };

} // namespace

TEST(IndexBox, CommonCellsAreThoseOfBoth)
{
  const IndexBox other{ { { 2, 0, 3 } }, { { 9, 3, 9 } } };
  const IndexBox common = Intersect(Box, other);
  ForCells({ { { 0, 0, 0 } }, { { 9, 9, 9 } } },
    [&](const Index3& p) { ASSERT_EQ(common.Contains(p), Box.Contains(p) && other.Contains(p)); });
  EXPECT_EQ(Intersect(Box, { { { 3, 0, 0 } }, { { 9, 9, 9 } } }).NumberOfCells(), 0);
}

TEST(IndexBox, GrowsWithinLimits)
{
  EXPECT_EQ(Grow(Box, 2, { { { 0, 0, 0 } }, { { 4, 9, 9 } } }),
    (IndexBox{ { { 0, 0, 0 } }, { { 4, 6, 7 } } }));
  EXPECT_EQ(Grow(IndexBox(), 2, Box), IndexBox());
  EXPECT_EQ(Moved(IndexBox(), { { 1, 2, 3 } }), IndexBox());
  EXPECT_EQ(Moved(Box, { { 1, 0, -1 } }), (IndexBox{ { { 2, 1, 0 } }, { { 4, 4, 4 } } }));
}

TEST(IndexBox, LevelsHoldEachOverlappingCell)
{
  EXPECT_EQ(ChangeLevel(Box, 1), (IndexBox{ { { 2, 2, 2 } }, { { 6, 8, 10 } } }));
  EXPECT_EQ(ChangeLevel(Box, -1), (IndexBox{ { { 0, 0, 0 } }, { { 2, 2, 3 } } }));
  EXPECT_EQ(ChangeLevel(ChangeLevel(Box, 3), -3), Box);
}

TEST(IndexBox, IndicesCountCellsWithXFastest)
{
  Index next = 0;
  ForCells(Box,
    [&](const Index3& p)
    {
      ASSERT_EQ(IndexInBox(Box, p), next);
      ASSERT_EQ(CellInBox(Box, next++), p);
    });
  EXPECT_EQ(next, Box.NumberOfCells());
  EXPECT_EQ(NodesOf(Box).NumberOfCells(), 3 * 4 * 5);
  EXPECT_EQ(TextOf({ { 1, 2, 3 } }), "cell (1, 2, 3)");
}
