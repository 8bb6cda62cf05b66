#include "Fractions/CellOverlaps.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

std::vector<double> EvenlySpaced(double first, double width, int cells)
{
  std::vector<double> nodes;
  for (int i = 0; i <= cells; ++i)
  {
    nodes.push_back(first + width * i);
  }
  return nodes;
}

} // namespace

TEST(CellOverlaps, SharesOfACellAreTheOverlaps)
{
  const std::vector<double> old{ 0.0, 1.0, 2.0, 4.0, 5.0 }, now{ 0.0, 2.5, 5.0 };
  const CellOverlaps overlaps =
    FindOverlaps({ old, old, old }, { now, now, now }, { {}, { { 2, 2, 2 } } });
  const AxisOverlaps& x = overlaps[0];
  EXPECT_EQ(x.Of(0).Begin, 0);
  EXPECT_EQ(x.Of(0).End, 3);
  EXPECT_EQ(x.Of(1).Begin, 2);
  EXPECT_EQ(x.Of(1).End, 4);
  EXPECT_DOUBLE_EQ(x.Share(0, 0), 0.4);
  EXPECT_DOUBLE_EQ(x.Share(0, 2), 0.2);
  EXPECT_DOUBLE_EQ(x.Share(1, 2), 0.6);
  EXPECT_DOUBLE_EQ(x.Share(1, 3), 0.4);
  EXPECT_EQ(Overlapped(overlaps, { { { 1, 0, 0 } }, { { 2, 2, 1 } } }),
    (IndexBox{ { { 2, 0, 0 } }, { { 4, 4, 3 } } }));
  EXPECT_EQ(x.EndWithin(2), 0);
  EXPECT_EQ(x.EndWithin(3), 1);
  EXPECT_EQ(x.EndBefore(0), 0);
  EXPECT_EQ(x.EndBefore(2), 1);
  EXPECT_EQ(x.EndBefore(3), 2);
}

TEST(CellOverlaps, NewNodesAreOldNodesWhereTheyShouldBe)
{
  for (double first : { 0.0, -0.3, 1e4 })
  {
    const std::vector<double> old = EvenlySpaced(first, 0.1, 48);
    EXPECT_EQ(ReplaceNodes(old, 0.1), old);
    const std::vector<double> pairs = ReplaceNodes(old, 0.2), others = ReplaceNodes(old, 0.25);
    ASSERT_EQ(pairs.size(), 25u);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      EXPECT_EQ(pairs[i], old[2 * i]);
    }
    ASSERT_EQ(others.size(), 20u); // 4.8 / 0.25 = 19.2
    EXPECT_EQ(others.front(), old.front());
    EXPECT_EQ(others.back(), old.back());
    EXPECT_NEAR(others[7] - first, 7 * 4.8 / 19, 1e-9);
  }
  EXPECT_EQ(ReplaceNodes({ 1.0, 2.0, 4.0 }, 100.0), (std::vector<double>{ 1.0, 4.0 }));
  const std::vector<double> graded{ 0.0, 1.0, 3.0 + 1e-8, 4.0 };
  EXPECT_EQ(ReplaceNodes(graded, 1.0), (std::vector<double>{ 0.0, 1.0, 2.0, 3.0 + 1e-8, 4.0 }));
}
