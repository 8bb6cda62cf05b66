/// Fragments that share faces, also across ranks.
#include "Report/Fragments/FragmentPairs.h"
#include "FragmentDrops.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>

using namespace vfm;
using namespace vfm::testing;

TEST(FragmentPairs, AreFoundAcrossRanks)
{
  constexpr Index count = 120;
  for (int ranks : { 1, 2, 3, 8, 27 })
  {
    std::set<FragmentPair> all;
    std::mutex mutex;
    RunOnRanks(ranks,
      [&](ThreadRanks& group)
      {
        const Drops drops = MakeDrops(count, group.Rank(), ranks);
        const std::vector<FragmentPair> pairs = FindFragmentPairs(ViewDrops(drops), group);
        EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
        for (const FragmentPair& pair : pairs)
        {
          EXPECT_EQ(std::count(drops.Fragment.begin(), drops.Fragment.end(), pair[0]) > 0, true);
        }
        const std::lock_guard<std::mutex> lock(mutex);
        all.insert(pairs.begin(), pairs.end());
      });
    std::set<FragmentPair> expected;
    for (int f = 1; f <= count; f += 2)
    {
      expected.insert({ { f, f + 1 } });
      expected.insert({ { f + 1, f } });
    }
    EXPECT_EQ(all, expected) << ranks;
  }
}

TEST(FragmentPairs, RejectFacesOfThreeElements)
{
  for (int ranks : { 1, 2 })
  {
    RunOnRanks(ranks,
      [ranks](ThreadRanks& group)
      {
        Drops drops = MakeDrops(8, group.Rank(), ranks);
        if (group.Rank() == 0)
        {
          drops.Add(0, 0);
          drops.Add(0, 0);
        }
        EXPECT_THROW(FindFragmentPairs(ViewDrops(drops), group), InputError);
      });
  }
}
