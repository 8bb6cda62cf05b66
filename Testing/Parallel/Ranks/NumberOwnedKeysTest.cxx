/// Numbers of keys that some ranks own, on ranks that are threads.
#include "Ranks/NumberOwnedKeys.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Key = std::array<int, 2>;

/// Returns keys of a rank and whether it owns them. No rank owns keys that end with 7.
std::map<Key, bool> KeysOf(int rank)
{
  std::mt19937 random(rank);
  std::map<Key, bool> keys;
  for (int i = 0; i < (rank * 53) % 200; ++i)
  {
    const Key key{ { static_cast<int>(random() % 12) - 6, static_cast<int>(random() % 90) } };
    keys[key] = key[1] % 10 != 7 && random() % 3 == 0;
  }
  return keys;
}

} // namespace

TEST(NumberOwnedKeys, NumbersAreThePlacesInTheListOfAllOwnedKeys)
{
  for (int count : { 1, 2, 3, 5, 6, 8, 27 })
  {
    std::map<Key, std::array<int, 2>> all; // ranks that have a key, ranks that own it
    for (int r = 0; r < count; ++r)
    {
      for (const auto& [key, isOwned] : KeysOf(r))
      {
        ++all[key][0];
        all[key][1] += isOwned;
      }
    }
    std::vector<Key> owned;
    for (const auto& [key, holders] : all)
    {
      if (holders[1] > 0)
      {
        owned.push_back(key);
      }
    }
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        std::vector<Key> keys;
        std::vector<unsigned char> isOwned;
        for (const auto& [key, isMine] : KeysOf(ranks.Rank()))
        {
          keys.push_back(key);
          isOwned.push_back(isMine);
        }
        const OwnedKeyNumbers numbers = NumberOwnedKeys(
          keys, isOwned, [](const Key& key) { return std::int64_t(key[0] + 6) * 100 + key[1]; },
          ranks);
        EXPECT_EQ(numbers.Total, static_cast<std::int64_t>(owned.size()));
        ASSERT_EQ(numbers.Numbers.size(), keys.size());
        ASSERT_EQ(numbers.IsShared.size(), keys.size());
        for (std::size_t k = 0; k < keys.size(); ++k)
        {
          const std::array<int, 2>& holders = all.at(keys[k]);
          EXPECT_EQ(numbers.IsShared[k] != 0, holders[0] > 1);
          ASSERT_EQ(numbers.Numbers[k] >= 0, holders[1] > 0);
          EXPECT_TRUE(numbers.Numbers[k] < 0 || owned.at(numbers.Numbers[k]) == keys[k]);
        }
      });
  }
}
