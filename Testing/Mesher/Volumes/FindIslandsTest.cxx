/// Islands of grains on ranks that are threads.
#include "Volumes/FindIslands.h"
#include "Grains.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <mutex>
#include <numeric>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Expects the islands on all ranks: each grain's lowest grain and size.
/// @return rounds of messages
int ExpectIslands(const Grains& grains, int count, const std::vector<int>& lowest)
{
  std::vector<Index> sizes(lowest.size(), 0);
  for (int f = 1; f <= grains.Count; ++f)
  {
    ++sizes[lowest[f]];
  }
  std::mutex lock;
  int rounds = 0;
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const FragmentShare share = ShareOf(grains, ranks);
      std::vector<FragmentPair> pairs;
      for (const auto& sum : AreasOf(grains, share))
      {
        pairs.push_back({ { sum.first.first, sum.first.second } });
      }
      const Islands islands = FindIslands(share, pairs);
      const std::lock_guard<std::mutex> guard(lock);
      for (std::size_t f = 1; f < share.Size(); ++f)
      {
        ASSERT_EQ(islands.Lowest[f], lowest[share.Ids[f]]) << share.Ids[f];
        EXPECT_EQ(islands.Sizes[f], sizes[lowest[share.Ids[f]]]);
      }
      rounds = islands.Rounds;
    });
  return rounds;
}

/// Returns chains of grains that wind through all ranks, with numbers in random order.
Grains MakeChains(int chains, int length, std::vector<int>& lowest)
{
  Grains grains;
  grains.Count = chains * length;
  std::vector<int> numbers(grains.Count);
  std::iota(numbers.begin(), numbers.end(), 1);
  std::shuffle(numbers.begin(), numbers.end(), std::mt19937(5));
  lowest.assign(grains.Count + 1, 0);
  std::vector<int> placeOf(grains.Count + 1);
  for (int c = 0; c < chains; ++c)
  {
    const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(c) * length;
    const int low = *std::min_element(first, first + length);
    for (int i = 0; i < length; ++i)
    {
      lowest[first[i]] = low;
      placeOf[first[i]] = i;
      if (i > 0)
      {
        grains.Add(first[i - 1], first[i], 1.0);
      }
      grains.Add(0, first[i], 1.0); // the outside does not connect
    }
  }
  grains.Home = [placeOf, length](int f, int ranks)
  { return static_cast<int>(static_cast<Index>(placeOf[f]) * ranks / length); };
  return grains;
}

} // namespace

TEST(FindIslands, ChainsThroughAllRanksNeedFewRounds)
{
  std::vector<int> lowest;
  const Grains one = MakeChains(1, 200, lowest);
  for (int count : { 1, 2, 3, 5, 6, 7, 8, 27 })
  {
    ExpectIslands(one, count, lowest);
  }
  EXPECT_LE(ExpectIslands(one, 64, lowest), 12);
  const Grains many = MakeChains(7, 100, lowest);
  EXPECT_LE(ExpectIslands(many, 33, lowest), 11);
}

TEST(FindIslands, GrainsWithoutNeighboursAreIslands)
{
  Grains grains;
  grains.Count = 20;
  std::vector<int> lowest(21);
  std::iota(lowest.begin(), lowest.end(), 0);
  for (int f = 1; f <= 20; f += 2)
  {
    grains.Add(0, f, 1.0);
  }
  grains.Home = [](int f, int ranks) { return f % ranks; };
  ExpectIslands(grains, 1, lowest);
  ExpectIslands(grains, 3, lowest);
}
