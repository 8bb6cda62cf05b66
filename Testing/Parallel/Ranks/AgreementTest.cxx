/// Lists and maxima that are equal on all ranks, on ranks that are threads.
#include "Ranks/Agreement.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(Agreement, UnionOfAllOrOfTheLowest)
{
  for (int count : { 1, 2, 3, 5, 8, 12, 27 })
  {
    RunOnRanks(count,
      [count](Ranks& ranks)
      {
        const int rank = ranks.Rank();
        const std::vector<int> own{ count - rank, 100 + rank, count - rank, 50 };
        std::vector<int> all;
        for (int value = 1; value <= count; ++value)
        {
          all.push_back(value);
        }
        all.push_back(50);
        for (int value = 0; value < count; ++value)
        {
          all.push_back(100 + value);
        }
        EXPECT_EQ(UnionOverRanks(ranks, own), all);
        for (std::size_t most : { 0, 1, 4, 1000 })
        {
          const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(most, all.size()));
          EXPECT_EQ(UnionOverRanks(ranks, own, most), std::vector<int>(all.begin(), end)) << most;
        }
      });
  }
}

TEST(Agreement, MaximumIsExactAndSendsOneNumber)
{
  for (int count : { 1, 2, 3, 8, 27 })
  {
    RunOnRanks(count,
      [count](ThreadRanks& ranks)
      {
        const std::int64_t base = (std::int64_t(1) << 60) + 1;
        EXPECT_EQ(MaximumOverRanks(base + ranks.Rank(), ranks), base + count - 1);
        EXPECT_LE(ranks.Sent().MessageBytes, 8 * ranks.Sent().Messages);
        EXPECT_EQ(MaximumOverRanks(-base - ranks.Rank(), ranks), -base);
        const std::int64_t least = std::numeric_limits<std::int64_t>::min();
        EXPECT_EQ(MaximumOverRanks(least, ranks), least);
      });
  }
}
