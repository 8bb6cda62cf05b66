/// Values of equal keys of any ranks, and answers to questions, on ranks that are threads.
#include "Ranks/MergeByKey.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Key = std::array<std::int64_t, 2>;

const int RankCounts[] = { 1, 2, 3, 5, 8, 12, 27 };

/// Returns keys of a rank, in random order, some repeated; every fourth rank has none.
std::vector<Key> KeysOf(int rank, int seed)
{
  std::mt19937 random(1000 * seed + rank);
  std::vector<Key> keys;
  for (int i = 0; rank % 4 != 3 && i < 200; ++i)
  {
    keys.push_back({ { static_cast<std::int64_t>(random() % 30), i % 7 } });
  }
  return keys;
}

std::int64_t ValueOf(int rank, std::size_t place)
{
  return 1 + rank * 1000 + static_cast<std::int64_t>(place);
}

std::int64_t Add(std::int64_t a, std::int64_t b)
{
  return a + b;
}

std::vector<std::int64_t> ValuesOf(int rank, std::size_t count)
{
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < count; ++i)
  {
    values.push_back(ValueOf(rank, i));
  }
  return values;
}

/// Returns the sums of the values of all ranks.
std::map<Key, std::int64_t> SumsOf(int count)
{
  std::map<Key, std::int64_t> sums;
  for (int rank = 0; rank < count; ++rank)
  {
    const std::vector<Key> keys = KeysOf(rank, 1);
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      sums[keys[i]] += ValueOf(rank, i);
    }
  }
  return sums;
}

} // namespace

TEST(MergeByKey, EachKeyGetsTheSumOfAllRanks)
{
  for (int count : RankCounts)
  {
    const std::map<Key, std::int64_t> sums = SumsOf(count);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const std::vector<Key> keys = KeysOf(ranks.Rank(), 1);
        const auto found = MergeByKey(keys, ValuesOf(ranks.Rank(), keys.size()), Add, ranks);
        ASSERT_EQ(found.size(), keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i)
        {
          EXPECT_EQ(found[i], sums.at(keys[i]));
        }
      });
  }
}

TEST(MergeByKey, QuestionsGetTheSumOrNone)
{
  for (int count : RankCounts)
  {
    std::map<Key, std::int64_t> sums = SumsOf(count);
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        const std::vector<Key> keys = KeysOf(ranks.Rank(), 1);
        std::vector<Key> questions = KeysOf(ranks.Rank() + 1, 2);
        questions.push_back({ { 5, 5 } }); // all ranks ask for it
        questions.push_back({ { -1, -1 } });
        const auto answers = AskByKey(
          keys, ValuesOf(ranks.Rank(), keys.size()), questions, std::int64_t(0), Add, ranks);
        ASSERT_EQ(answers.size(), questions.size());
        for (std::size_t i = 0; i < questions.size(); ++i)
        {
          const auto sum = sums.find(questions[i]);
          EXPECT_EQ(answers[i], sum == sums.end() ? 0 : sum->second);
        }
        EXPECT_LE(ranks.Sent().Messages, 3 * (count == 1 ? 0 : 1 + std::log2(count)));
      });
  }
}
