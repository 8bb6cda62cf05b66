/// Values of equal keys on ranks that are threads.
#include "Ranks/KeyMerge.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const int RankCounts[] = { 1, 2, 3, 4, 5, 6, 7, 8, 12, 27 };

/// Returns keys of a rank, ascending: some that all ranks have, some of a few ranks, some its own.
std::vector<std::int64_t> KeysOf(int rank)
{
  std::mt19937 random(rank);
  std::set<std::int64_t> keys{ -3, 1000000007, std::int64_t(1) << 40 };
  for (int i = 0; i < rank % 4 * 50; ++i) // every fourth rank has only the common keys
  {
    keys.insert(static_cast<std::int64_t>(random() % 200));
    keys.insert(1000 * rank + i);
  }
  return { keys.begin(), keys.end() };
}

std::int64_t ValueOf(int rank, std::int64_t key)
{
  return rank * 7 + (key & 15);
}

} // namespace

TEST(KeyMerge, EachRankGetsTheSumsOfItsKeys)
{
  for (int count : RankCounts)
  {
    std::map<std::int64_t, std::array<std::int64_t, 2>> expected; // sum of values, greatest rank
    for (int r = 0; r < count; ++r)
    {
      for (std::int64_t key : KeysOf(r))
      {
        expected[key][0] += ValueOf(r, key);
        expected[key][1] += 1;
      }
    }
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const std::vector<std::int64_t> keys = KeysOf(ranks.Rank());
        const KeyMerge<std::int64_t> ways(keys, ranks);
        for (int round = 0; round < 2; ++round) // a way can be used again
        {
          std::vector<std::int64_t> values;
          for (std::int64_t key : keys)
          {
            values.insert(values.end(), { ValueOf(ranks.Rank(), key), 1 });
          }
          ways.Merge(values, 2, [](std::int64_t& a, std::int64_t b) { a += b; });
          ASSERT_EQ(values.size(), 2 * keys.size());
          for (std::size_t k = 0; k < keys.size(); ++k)
          {
            EXPECT_EQ(values[2 * k], expected[keys[k]][0]) << keys[k];
            EXPECT_EQ(values[2 * k + 1], expected[keys[k]][1]) << keys[k];
          }
        }
      });
  }
}

TEST(KeyMerge, EachKeyHasOneHomeWithAllValues)
{
  for (int count : RankCounts)
  {
    std::map<std::int64_t, std::int64_t> expected;
    for (int r = 0; r < count; ++r)
    {
      for (std::int64_t key : KeysOf(r))
      {
        expected[key] = std::max(expected[key], ValueOf(r, key));
      }
    }
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const std::vector<std::int64_t> keys = KeysOf(ranks.Rank());
        const int homes = CountHomes(ranks);
        const auto homeOf = [homes](std::int64_t key) { return MeetingRank(key, homes); };
        const KeyMerge<std::int64_t> ways(keys, homeOf, ranks);
        std::vector<std::int64_t> values;
        for (std::int64_t key : keys)
        {
          values.push_back(ValueOf(ranks.Rank(), key));
        }
        values = ways.ToHome(
          std::move(values), 1, [](std::int64_t& a, std::int64_t b) { a = std::max(a, b); });
        std::vector<std::array<std::int64_t, 2>> mine;
        for (std::size_t k = 0; ranks.Rank() < homes && k < values.size(); ++k)
        {
          EXPECT_EQ(homeOf(ways.HomeKeys()[k]), ranks.Rank());
          mine.push_back({ { ways.HomeKeys()[k], values[k] } });
        }
        const auto all = GatherItems(ranks, mine);
        std::map<std::int64_t, std::int64_t> found;
        for (const auto& item : all)
        {
          found[item[0]] = item[1];
        }
        EXPECT_EQ(all.size(), expected.size()); // no key has two homes
        EXPECT_EQ(found, expected);
      });
  }
}

TEST(KeyMerge, MessagesGrowWithTheLogarithmOfRanks)
{
  for (int count : { 1, 2, 8, 27, 32 })
  {
    RunOnRanks(count,
      [count](ThreadRanks& ranks)
      {
        const KeyMerge<std::int64_t> ways({ 1, 2, 3 }, ranks); // keys of all ranks
        const std::int64_t before = ranks.Sent().Messages;
        std::vector<double> values{ 1.0, 2.0, 3.0 };
        ways.Merge(values, 1, [](double& a, double b) { a = std::max(a, b); });
        int bits = 0;
        while (1 << (bits + 1) <= count)
        {
          ++bits;
        }
        EXPECT_LE(ranks.Sent().Messages - before, 2 * (bits + 1));
        EXPECT_EQ(ranks.Sent().GatheredBytes, 0);
      });
  }
}
