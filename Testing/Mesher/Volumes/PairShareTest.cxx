/// Pairs of grains that ranks share.
#include "Volumes/PairShare.h"
#include "Grains.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(PairShare, OneRankCountsEachPairAndAllGetItsSum)
{
  const Grains lattice = MakeLattice(4, true);
  for (int count : { 1, 3, 8 })
  {
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const FragmentShare share = ShareOf(lattice, ranks);
        const PairSumMap mine = AreasOf(lattice, share);
        std::vector<FragmentPair> list;
        std::vector<ExactSum> sums;
        for (const auto& sum : mine)
        {
          list.push_back({ { sum.first.first, sum.first.second } });
          sums.push_back(sum.second);
        }
        const PairShare pairs(share, list, share.Shared);
        EXPECT_EQ(pairs.Pairs(), list);
        std::vector<ExactSum> ones(share.Size());
        for (ExactSum& one : ones)
        {
          one.Add(1.0);
        }
        pairs.Sum(sums, ones);
        std::vector<std::int64_t> holders(lattice.Count + 1, 0);
        for (int id : share.Ids)
        {
          ++holders[id];
        }
        ranks.Sum(holders);
        EXPECT_EQ(ones[0].Value(), 1.0);
        for (std::size_t f = 1; f < share.Size(); ++f)
        {
          EXPECT_EQ(ones[f].Value(), static_cast<double>(holders[share.Ids[f]]));
        }
        std::vector<std::int64_t> counts(lattice.Areas.size(), 0);
        for (std::size_t p = 0; p < list.size(); ++p)
        {
          const auto area = std::find_if(lattice.Areas.begin(), lattice.Areas.end(),
            [&](const PairSum& sum)
            { return sum.First == share.Ids[list[p][0]] && sum.Second == share.Ids[list[p][1]]; });
          ASSERT_NE(area, lattice.Areas.end());
          EXPECT_EQ(sums[p].Value(), area->Value.Value());
          counts[area - lattice.Areas.begin()] += pairs.IsMine(p);
        }
        ranks.Sum(counts);
        EXPECT_EQ(counts, std::vector<std::int64_t>(lattice.Areas.size(), 1));
      });
  }
}
