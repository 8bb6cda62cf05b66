/// Fragments of each rank, and their rows at ranks by ranges of ids.
#include "Report/FragmentWays.h"
#include "FragmentDrops.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(FragmentWays, CombineTheValuesOfAllRanks)
{
  constexpr Index count = 100;
  for (int ranks : { 1, 2, 3, 5, 8, 27 })
  {
    std::vector<std::vector<int>> homes(ranks);
    RunOnRanks(ranks,
      [&](ThreadRanks& group)
      {
        const Drops drops = MakeDrops(count, group.Rank(), ranks);
        const FragmentWays ways(ViewDrops(drops), { static_cast<int>(count) + 1 }, group);
        std::vector<Index> elements(ways.Ids().size(), 0);
        std::vector<double> ids(ways.Ids().begin(), ways.Ids().end());
        std::vector<ExactSum> volumes(2 * ids.size());
        for (std::size_t e = 0; e < drops.Fragment.size(); ++e)
        {
          const std::size_t place = ways.PlaceOfElement()[e];
          ASSERT_EQ(ways.Ids()[place], drops.Fragment[e]);
          ++elements[place];
          volumes[2 * place].Add(0.5);
          volumes[2 * place + 1].Add(0.25);
        }
        elements = ways.Sum(elements, 1);
        ids = ways.Max(ids, 1);
        volumes = ways.Sum(volumes, 2);
        homes[group.Rank()] = ways.HomeIds();
        ASSERT_EQ(elements.size(), ways.HomeIds().size());
        for (std::size_t r = 0; r < elements.size(); ++r)
        {
          const int id = ways.HomeIds()[r];
          EXPECT_EQ(ways.HomeOf(id), group.Rank());
          EXPECT_EQ(elements[r], id > count ? 0 : 2);
          EXPECT_EQ(ids[r], id);
          EXPECT_EQ(volumes[2 * r].Value(), id > count ? 0.0 : 1.0);
          EXPECT_EQ(volumes[2 * r + 1].Value(), id > count ? 0.0 : 0.5);
        }
      });
    std::vector<int> all;
    for (const std::vector<int>& home : homes)
    {
      all.insert(all.end(), home.begin(), home.end());
    }
    ASSERT_EQ(all.size(), static_cast<std::size_t>(count + 1));
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  }
}

TEST(FragmentWays, MayBeEmpty)
{
  RunOnRanks(3,
    [](ThreadRanks& group)
    {
      const FragmentWays ways(MeshData(), {}, group);
      EXPECT_TRUE(ways.Ids().empty() && ways.HomeIds().empty());
      EXPECT_TRUE(ways.Sum(std::vector<Index>(), 1).empty());
    });
}
