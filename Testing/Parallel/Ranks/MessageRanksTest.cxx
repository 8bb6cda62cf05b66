/// Messages and reductions on ranks that are threads.
#include "Ranks/MessageRanks.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace vfm;
using namespace vfm::testing;

TEST(MessageRanks, ReductionsAreEqualOnAllRanks)
{
  for (int count : { 1, 2, 3, 5, 8 })
  {
    RunOnRanks(count,
      [count](Ranks& ranks)
      {
        std::vector<std::int64_t> values{ ranks.Rank(), 1, std::int64_t(1) << 50 };
        ranks.Sum(values);
        EXPECT_EQ(values[0], count * (count - 1) / 2);
        EXPECT_EQ(values[1], count);
        EXPECT_EQ(values[2], count * (std::int64_t(1) << 50));
        EXPECT_EQ(ranks.Max(-10.0 - ranks.Rank()), -10.0);
        std::vector<double> rising{ double(ranks.Rank()), -double(ranks.Rank()), 7.0 };
        ranks.Max(rising);
        EXPECT_EQ(rising, (std::vector<double>{ count - 1.0, 0.0, 7.0 }));
        const std::vector<Bytes> all = ranks.Gather(Bytes(ranks.Rank() * 100, 'a'));
        ASSERT_EQ(static_cast<int>(all.size()), count);
        for (int r = 0; r < count; ++r)
        {
          EXPECT_EQ(all[r], Bytes(r * 100, 'a'));
        }
      });
  }
}

TEST(MessageRanks, LargeMessagesArriveWhole)
{
  RunOnRanks(2,
    [](ThreadRanks& ranks)
    {
      Bytes mine(2 * Transport::LongestPiece + 7);
      for (std::size_t i = 0; i < mine.size(); ++i)
      {
        mine[i] = static_cast<char>(i % 251 + ranks.Rank());
      }
      const std::vector<Bytes> got = ranks.Exchange({ 1 - ranks.Rank() }, { mine });
      ASSERT_EQ(got.size(), 1u);
      ASSERT_EQ(got[0].size(), mine.size());
      for (std::size_t i = 0; i < mine.size(); ++i)
      {
        ASSERT_EQ(got[0][i], static_cast<char>(i % 251 + 1 - ranks.Rank()));
      }
      EXPECT_EQ(ranks.Sent().Messages, 1);
      EXPECT_EQ(ranks.Sent().MessageBytes, static_cast<std::int64_t>(mine.size()));
    });
}
