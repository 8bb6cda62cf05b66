/// Numbers of keys on ranks that are threads.
#include "Ranks/NumberKeys.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns keys of a rank, ascending: with negative and huge ones, and some of several ranks.
std::vector<std::int64_t> KeysOf(int rank)
{
  std::mt19937_64 random(rank);
  std::set<std::int64_t> keys;
  for (int i = 0; i < (rank * 37) % 300; ++i)
  {
    keys.insert(static_cast<std::int64_t>(random() % 5000) - 1000);
    keys.insert(static_cast<std::int64_t>(random() >> 3));
  }
  return { keys.begin(), keys.end() };
}

} // namespace

TEST(NumberKeys, NumbersAreThePlacesInTheListOfAllKeys)
{
  for (int count : { 1, 2, 3, 5, 6, 7, 8, 27 })
  {
    std::set<std::int64_t> all;
    for (int r = 0; r < count; ++r)
    {
      const std::vector<std::int64_t> keys = KeysOf(r);
      all.insert(keys.begin(), keys.end());
    }
    const std::vector<std::int64_t> sorted(all.begin(), all.end());
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const std::vector<std::int64_t> keys = KeysOf(ranks.Rank());
        const KeyNumbers numbers = NumberKeys(
          keys, [](std::int64_t key) { return key; }, ranks);
        EXPECT_EQ(numbers.Total, static_cast<std::int64_t>(sorted.size()));
        ASSERT_EQ(numbers.Numbers.size(), keys.size());
        for (std::size_t k = 0; k < keys.size(); ++k)
        {
          EXPECT_EQ(sorted[numbers.Numbers[k]], keys[k]);
        }
      });
  }
}

TEST(NumberKeys, ItemsMayBeRepeatedAndInAnyOrder)
{
  using Item = std::array<std::int64_t, 2>;
  const auto itemsOf = [](int rank)
  {
    std::mt19937 random(rank);
    std::vector<Item> items;
    for (int i = 0; i < rank * 31 % 200; ++i)
    {
      items.push_back({ { static_cast<std::int64_t>(random() % 40) - 7,
        static_cast<std::int64_t>(random() % 3) } });
    }
    return items;
  };
  for (int count : { 1, 2, 3, 5, 8, 12, 27 })
  {
    std::set<Item> all;
    for (int r = 0; r < count; ++r)
    {
      const std::vector<Item> items = itemsOf(r);
      all.insert(items.begin(), items.end());
    }
    const std::vector<Item> sorted(all.begin(), all.end());
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const std::vector<Item> items = itemsOf(ranks.Rank());
        const KeyNumbers found = NumberItems(items, FirstOfKey(), ranks);
        EXPECT_EQ(found.Total, static_cast<std::int64_t>(sorted.size()));
        ASSERT_EQ(found.Numbers.size(), items.size());
        for (std::size_t i = 0; i < items.size(); ++i)
        {
          EXPECT_EQ(sorted[found.Numbers[i]], items[i]);
        }
      });
  }
}

TEST(NumberKeys, ValuesInGroupsRiseAndStayInRange)
{
  for (std::int64_t greatest : { std::int64_t(0), std::int64_t(7), std::int64_t(1) << 62 })
  {
    const ValueInGroup value(greatest);
    std::int64_t last = -1;
    for (std::int64_t group = 0; group < 1000; ++group)
    {
      EXPECT_GT(value(group, 0), last); // groups do not overlap
      EXPECT_GE(value(group, greatest / 2), value(group, 0));
      EXPECT_GE(value(group, greatest), value(group, greatest / 2));
      last = value(group, greatest);
    }
    EXPECT_LT(last, std::int64_t(1) << 60);
  }
}

TEST(NumberKeys, SumOfLowerRanks)
{
  for (int count : { 1, 2, 3, 7, 8, 27 })
  {
    RunOnRanks(count,
      [](Ranks& ranks)
      {
        const std::int64_t r = ranks.Rank();
        EXPECT_EQ(SumOfLowerRanks(r + 1, ranks), r * (r + 1) / 2);
        EXPECT_EQ(
          SumOfLowerRanks({ 1, r }, ranks), (std::vector<std::int64_t>{ r, r * (r - 1) / 2 }));
      });
  }
}

TEST(NumberKeys, RisingHomesRiseAndShareTheValues)
{
  // Dense values far from 0; and dense ones among few that are far away.
  for (const std::int64_t far : { std::int64_t(0), std::int64_t(1) << 60 })
  {
    RunOnRanks(12,
      [far](Ranks& ranks)
      {
        std::vector<std::int64_t> values;
        for (int i = 0; i < 3000; ++i)
        {
          values.push_back((std::int64_t(1) << 61) - far + 3000 * ranks.Rank() + i);
        }
        if (far > 0)
        {
          values.insert(values.begin(), -5);
          values.insert(values.end(), { std::int64_t(1) << 61, std::int64_t(1) << 62 });
        }
        const RisingHomes homes(values, ranks);
        std::vector<std::int64_t> counts(CountHomes(ranks), 0);
        int before = 0;
        for (std::int64_t value : values)
        {
          const int home = homes(value);
          EXPECT_GE(home, before);
          ASSERT_LT(home, CountHomes(ranks));
          before = home;
          ++counts[home];
        }
        ranks.Sum(counts);
        for (std::int64_t own : counts)
        {
          EXPECT_NEAR(static_cast<double>(own), 4500.0, 900.0) << far;
        }
      });
  }
}
