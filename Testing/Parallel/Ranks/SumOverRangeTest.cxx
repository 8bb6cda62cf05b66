/// Sums over some of several ranks.
#include "Ranks/SumOverRange.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(SumOverRange, EachRangeHasItsOwnSums)
{
  for (int count : { 1, 2, 3, 6, 7, 13, 27 })
  {
    for (int cut = 1; cut <= count; ++cut) // ranks below and from there on
    {
      RunOnRanks(count,
        [&](Ranks& ranks)
        {
          const bool isUpper = ranks.Rank() >= cut;
          const int first = isUpper ? cut : 0, end = isUpper ? count : cut;
          std::vector<std::int64_t> values{ 1, ranks.Rank(), std::int64_t(1) << 60 };
          values[2] = ranks.Rank() == first ? values[2] : -3;
          SumOverRange(first, end - first, values, ranks);
          const std::int64_t size = end - first;
          EXPECT_EQ(values[0], size);
          EXPECT_EQ(values[1], size * (first + end - 1) / 2);
          EXPECT_EQ(values[2], (std::int64_t(1) << 60) - 3 * (size - 1));
        });
    }
  }
}

TEST(SumOverRange, NoValues)
{
  RunOnRanks(3,
    [](Ranks& ranks)
    {
      std::vector<std::int64_t> none;
      SumOverRange(0, 3, none, ranks);
      EXPECT_TRUE(none.empty());
    });
}
