/// Numbers of entities on ranks that are threads.
#include "Geometry/EntityNumbers.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Set = std::vector<int>;
constexpr int Largest = 9;

/// Returns sets of a rank and whether it owns them. Many begin with the same members. No rank owns
/// sets that end with 7.
std::map<Set, bool> SetsOf(int rank, std::size_t longest)
{
  std::mt19937 random(rank);
  std::map<Set, bool> sets;
  for (int i = 0; i < rank % 4 * 40; ++i)
  {
    Set set(1 + random() % longest, 1);
    set.back() = 1 + static_cast<int>(random() % Largest);
    set[random() % set.size()] = 1 + static_cast<int>(random() % 2);
    sets[set] = set.back() != 7 && random() % 2 == 0;
  }
  return sets;
}

} // namespace

TEST(EntityNumbers, SetsAreNumberedInLexicographicOrder)
{
  for (std::size_t longest : { 1u, 3u, 8u, 9u, 15u, 16u, 40u })
  {
    for (int count : { 1, 2, 3, 5, 8, 27 })
    {
      SCOPED_TRACE(std::to_string(longest) + " members, " + std::to_string(count) + " ranks");
      std::map<Set, int> holders;
      std::set<Set> owned;
      for (int r = 0; r < count; ++r)
      {
        for (const auto& [set, isOwned] : SetsOf(r, longest))
        {
          ++holders[set];
          if (isOwned)
          {
            owned.insert(set);
          }
        }
      }
      const std::vector<Set> sorted(owned.begin(), owned.end());
      RunOnRanks(count,
        [&](Ranks& ranks)
        {
          const std::map<Set, bool> mine = SetsOf(ranks.Rank(), longest);
          std::vector<std::pair<Set, bool>> items(mine.begin(), mine.end());
          items.insert(items.end(), mine.begin(), mine.end()); // may be repeated
          const EntityNumbers<Set> numbers =
            NumberSets(EntityKeys<Set>(std::move(items)), Largest, "sets", ranks);
          EXPECT_EQ(numbers.Total, static_cast<Index>(sorted.size()));
          std::size_t entities = 0;
          for (const auto& [set, isOwned] : mine)
          {
            const int number = numbers.Find(set);
            ASSERT_EQ(number > 0, owned.count(set) > 0);
            if (number > 0)
            {
              ++entities;
              EXPECT_EQ(sorted.at(number - 1), set);
              EXPECT_EQ(numbers.IsShared[numbers.FindRow(set)] != 0, holders[set] > 1);
            }
          }
          EXPECT_EQ(numbers.Keys.size(), entities);
        });
    }
  }
}

TEST(EntityNumbers, RepeatedKeysAreOwnedIfOneIs)
{
  const EntityKeys<int> keys(
    { { 3, false }, { 1, true }, { 3, true }, { 2, false }, { 1, false } });
  EXPECT_EQ(keys.Keys, (std::vector<int>{ 1, 2, 3 }));
  EXPECT_EQ(keys.IsOwned, (std::vector<unsigned char>{ 1, 0, 1 }));
}

TEST(EntityNumbers, MoreThan32BitsCanNumberAreRefusedOnAllRanks)
{
  constexpr Index largest = 2147483647;
  RunOnRanks(3,
    [](Ranks& ranks)
    {
      // A rank has few of them, or none.
      const std::vector<Index> keys(ranks.Rank(), 5);
      const OwnedKeyNumbers most{ std::vector<std::int64_t>(keys.size(), largest - 1),
        std::vector<unsigned char>(keys.size(), 0), largest };
      const EntityNumbers<Index> numbers(keys, most, "curves");
      EXPECT_EQ(numbers.Find(5), ranks.Rank() > 0 ? largest : 0);
      for (const char* things : { "surfaces", "curves", "vertices" })
      {
        const OwnedKeyNumbers more{ most.Numbers, most.IsShared, largest + 1 };
        try
        {
          EntityNumbers<Index>(keys, more, things);
          ADD_FAILURE();
        }
        catch (const InputError& error)
        {
          EXPECT_NE(
            std::string(error.what()).find(std::string("2147483648 ") + things), std::string::npos)
            << error.what();
        }
      }
    });
}

TEST(EntityNumbers, SharedRowsAreCombined)
{
  // Rank r has rows r to r + 3; the row of r alone is that of the first and of the last rank.
  constexpr int count = 6;
  RunOnRanks(count,
    [](Ranks& ranks)
    {
      const int rank = ranks.Rank();
      std::vector<int> ids, values;
      std::vector<unsigned char> isShared;
      for (int id = rank; id < rank + 4; ++id)
      {
        ids.push_back(id);
        isShared.push_back(id > 0 && id < count + 2);
        values.insert(values.end(), { id, 1 });
      }
      SharedRows(ids, isShared, ranks).Merge(values, 2, [](int& a, int b) { a += b; });
      for (int row = 0; row < 4; ++row)
      {
        const int id = ids[row];
        const int holders = std::min(id, count - 1) - std::max(id - 3, 0) + 1;
        EXPECT_EQ(values[2 * row], id * holders);
        EXPECT_EQ(values[2 * row + 1], holders);
      }
    });
}
