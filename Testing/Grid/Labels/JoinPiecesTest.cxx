/// Components of many ranks that are threads, against disjoint sets of all of them.
#include "Labels/JoinPieces.h"
#include "Base/DisjointSets.h"
#include "Ranks/NumberLimit.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Components of all ranks. Component c belongs to rank RankOf[c].
struct World
{
  int Ranks = 0;
  std::vector<int> RankOf;
  std::vector<Index> Lowest, Labels;
  std::vector<std::array<int, 2>> Pairs; // any direction
};

/// Each rank has a component of each filament, which leads through all ranks.
World MakeFilaments(int ranks, int filaments, bool isShuffled)
{
  World world;
  world.Ranks = ranks;
  for (int r = 0; r < ranks; ++r)
  {
    for (int f = 0; f < filaments; ++f)
    {
      if (r > 0)
      {
        world.Pairs.push_back({ { r * filaments + f, (r - 1) * filaments + f } });
      }
      world.RankOf.push_back(r);
      world.Labels.push_back(f % 5);
    }
  }
  world.Lowest.resize(world.RankOf.size());
  std::iota(world.Lowest.begin(), world.Lowest.end(), 1000);
  std::mt19937 random(ranks);
  for (std::size_t c = world.Lowest.size(); isShuffled && c > 1; --c)
  {
    std::swap(world.Lowest[c - 1], world.Lowest[random() % c]);
  }
  return world;
}

/// Random components and pairs, also within a rank; ranks are peers of all others.
World MakeRandom(int ranks, int components, int pairs, unsigned seed)
{
  World world;
  world.Ranks = ranks;
  std::mt19937 random(seed);
  for (int c = 0; c < components; ++c)
  {
    world.RankOf.push_back(static_cast<int>(random() % ranks));
    world.Lowest.push_back(static_cast<Index>(random()) * 1000003 + c);
    world.Labels.push_back(0);
  }
  for (int p = 0; p < pairs; ++p)
  {
    world.Pairs.push_back(
      { { static_cast<int>(random() % components), static_cast<int>(random() % components) } });
  }
  return world;
}

/// Returns the fragment of each component and the number of fragments.
std::pair<std::vector<int>, int> FindFragments(const World& world)
{
  std::vector<Index> parent = MakeSets(world.RankOf.size());
  for (const auto& pair : world.Pairs)
  {
    Join(parent, pair[0], pair[1]);
  }
  std::map<Index, Index> lowest; // of each set
  for (std::size_t c = 0; c < parent.size(); ++c)
  {
    const Index root = FindRoot(parent, static_cast<Index>(c));
    const auto at = lowest.emplace(root, world.Lowest[c]).first;
    at->second = std::min(at->second, world.Lowest[c]);
  }
  std::map<Index, int> numbers;
  for (const auto& set : lowest)
  {
    numbers[set.second] = 0;
  }
  int next = 0;
  for (auto& number : numbers)
  {
    number.second = ++next;
  }
  std::vector<int> fragments;
  for (std::size_t c = 0; c < parent.size(); ++c)
  {
    fragments.push_back(numbers[lowest[FindRoot(parent, static_cast<Index>(c))]]);
  }
  return { fragments, next };
}

struct Counts
{
  int Rounds, Shortcuts;
  std::int64_t Gathered;
};

/// Joins the components of a world and checks all parts of the result.
Counts CheckWorld(const World& world)
{
  const auto [expected, total] = FindFragments(world);
  std::vector<std::vector<int>> components(world.Ranks); // of each rank
  std::vector<int> place;
  for (std::size_t c = 0; c < world.RankOf.size(); ++c)
  {
    place.push_back(static_cast<int>(components[world.RankOf[c]].size()));
    components[world.RankOf[c]].push_back(static_cast<int>(c));
  }
  std::map<int, std::vector<int>> ranksOf; // of each fragment, ascending
  for (int r = 0; r < world.Ranks; ++r)
  {
    for (int c : components[r])
    {
      std::vector<int>& list = ranksOf[expected[c]];
      if (list.empty() || list.back() != r)
      {
        list.push_back(r);
      }
    }
  }
  Counts counts{};
  RunOnRanks(world.Ranks,
    [&, &fragments = expected, &all = total](ThreadRanks& ranks)
    {
      const int rank = ranks.Rank();
      std::vector<Piece> mine;
      for (int c : components[rank])
      {
        mine.push_back({ world.Lowest[c], world.Labels[c] });
      }
      PiecePairs same;
      std::vector<int> peers;
      for (std::size_t p = 0; p < world.Pairs.size(); ++p)
      {
        const auto [a, b] = world.Pairs[p];
        const auto idOf = [&](int c)
        { return (static_cast<Index>(world.RankOf[c]) << 32) + place[c]; };
        if (world.RankOf[a] == rank) // only one of both ranks lists the pair
        {
          same.push_back({ { idOf(a), idOf(b) } });
          peers.push_back(world.RankOf[b]);
        }
        else if (world.RankOf[b] == rank)
        {
          peers.push_back(world.RankOf[a]);
        }
      }
      const JoinedPieces joined = JoinPieces(mine, same, peers, ranks);
      const FragmentShare& share = joined.Share;
      EXPECT_EQ(share.Total, all);
      ASSERT_EQ(joined.Fragments.size(), mine.size());
      EXPECT_TRUE(std::is_sorted(share.Ids.begin(), share.Ids.end()));
      std::vector<std::int64_t> owners(all + 1, 0);
      for (std::size_t i = 0; i < mine.size(); ++i)
      {
        const int c = components[rank][i], f = joined.Fragments[i];
        ASSERT_EQ(share.Ids[f], fragments[c]);
        EXPECT_EQ(share.Find(fragments[c]), f);
        EXPECT_EQ(share.Materials[f], world.Labels[c]);
        EXPECT_EQ(share.IsShared[f] != 0, ranksOf[fragments[c]].size() > 1);
        owners[fragments[c]] |= share.IsMine[f];
      }
      ranks.Sum(owners);
      EXPECT_EQ(std::count(owners.begin(), owners.end(), 1), all);
      std::vector<ExactSum> sums(share.Size());
      for (int f : joined.Fragments)
      {
        sums[f].Add(0.1);
      }
      const std::vector<double> values = share.Sum(sums);
      for (std::size_t i = 0; i < mine.size(); ++i)
      {
        const auto parts =
          std::count(fragments.begin(), fragments.end(), fragments[components[rank][i]]);
        EXPECT_NEAR(values[joined.Fragments[i]], 0.1 * static_cast<double>(parts), 1e-9);
      }
      if (rank == 0)
      {
        counts = { joined.Rounds, joined.Shortcuts, ranks.Sent().GatheredBytes };
      }
    });
  EXPECT_EQ(counts.Gathered, 0);
  return counts;
}

} // namespace

TEST(JoinPieces, RandomComponentsOnAnyRanks)
{
  for (int ranks : { 1, 2, 3, 5, 6, 7, 8, 12 })
  {
    for (unsigned seed = 0; seed < 6; ++seed)
    {
      SCOPED_TRACE(std::to_string(ranks) + " ranks, seed " + std::to_string(seed));
      const int components = static_cast<int>(10 + 20 * seed);
      CheckWorld(MakeRandom(ranks, components, components / 2 + static_cast<int>(seed), seed));
    }
  }
}

TEST(JoinPieces, RanksWithoutComponents)
{
  CheckWorld(MakeRandom(8, 0, 0, 1));
  World world = MakeFilaments(3, 2, false);
  world.Ranks = 7; // the last four have none
  CheckWorld(world);
}

// Labels that only spread between neighbours would take as many rounds as there are ranks.
TEST(JoinPieces, FilamentsThroughManyRanksNeedFewRounds)
{
  for (bool isShuffled : { false, true })
  {
    for (int ranks : { 27, 64 })
    {
      const Counts counts = CheckWorld(MakeFilaments(ranks, 3, isShuffled));
      EXPECT_LE(counts.Rounds, 9) << ranks;
      EXPECT_GT(counts.Shortcuts, 0);
    }
  }
}

TEST(JoinPieces, PartsOfTwoRanksNeedOneRound)
{
  World world;
  world.Ranks = 8;
  for (int c = 0; c < 80; ++c)
  {
    world.RankOf.push_back(c / 10);
    world.Lowest.push_back(7 * c);
    world.Labels.push_back(1);
    if (c >= 10 && c % 20 == 10)
    {
      world.Pairs.push_back({ { c - 10, c } });
    }
  }
  const Counts counts = CheckWorld(world);
  EXPECT_LE(counts.Rounds, 1);
  EXPECT_EQ(counts.Shortcuts, 0);
}

TEST(NumberLimit, MoreThan32BitsAreRefused)
{
  EXPECT_NO_THROW(CheckNumberLimit(2147483647, "fragments"));
  try
  {
    CheckNumberLimit(2147483648, "fragments");
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_EQ(error.Code(), ErrorCode::TooLarge);
    EXPECT_NE(std::string(error.what()).find("2147483648 fragments"), std::string::npos);
  }
}
