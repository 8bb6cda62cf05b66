/// Sums of pairs over ranks, and shifts that correct volumes.
#include "Base/PairSums.h"
#include "RandomDraw.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(PairSums, RanksAddTheirParts)
{
  RunOnRanks(3,
    [](Ranks& ranks)
    {
      PairSumMap mine;
      mine[{ 0, 1 }].Add(1.0 + ranks.Rank());
      mine[{ ranks.Rank(), 5 }].Add(0.25);
      const std::vector<PairSum> all = GatherPairSums(mine, ranks);
      ASSERT_EQ(all.size(), 4u);
      EXPECT_EQ(all[0].Second, 1);
      EXPECT_EQ(all[0].Value.Value(), 6.0);
      for (int r = 0; r < 3; ++r)
      {
        EXPECT_EQ(all[r + 1].First, r);
        EXPECT_EQ(all[r + 1].Second, 5);
        EXPECT_EQ(all[r + 1].Value.Value(), 0.25);
      }
    });
}

TEST(PairSums, ShiftsGiveWhatLacks)
{
  RandomDraw random(3);
  const int items = 8;
  std::vector<PairSum> sums;
  for (int a = 0; a < items; ++a)
  {
    for (int b = a + 1; b < items; ++b)
    {
      sums.push_back({ a, b, {} });
      sums.back().Value.Add(random.Between(1.0, 50.0));
    }
  }
  std::vector<double> lack(items), gained(items, 0.0);
  std::generate(lack.begin(), lack.end(), [&] { return random.Between(-1.0, 1.0); });
  const std::vector<double> mu = SolveForLack(sums, lack);
  EXPECT_EQ(mu[0], 0.0);
  for (const PairSum& sum : sums)
  {
    const double change = sum.Value.Value() * (mu[sum.First] - mu[sum.Second]);
    gained[sum.First] += change;
    gained[sum.Second] -= change;
  }
  for (int a = 1; a < items; ++a)
  {
    EXPECT_NEAR(gained[a], lack[a], 1e-5);
  }
}
