/// Checks of blocks on ranks, against checks with the blocks of all ranks in one place.
#include "Input/BlockChecks.h"
#include "BlockPieces.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const int RankCounts[] = { 1, 2, 3, 5, 8, 27 };

/// Returns the message of an error, or "".
template <class Check>
std::string MessageOf(const Check& check)
{
  try
  {
    check();
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

bool Meet(const BlockPlace& a, int levelOfA, const BlockPlace& b, int levelOfB)
{
  const int level = std::min(levelOfA, levelOfB);
  return Intersect(ChangeLevel(a.Box, level - levelOfA), ChangeLevel(b.Box, level - levelOfB))
           .NumberOfCells() > 0;
}

/// Returns the blocks of a level that have common cells with a block of a rank, and its own.
std::vector<BlockPlace> ListPlaces(const InputLevels& all, int level, int rank)
{
  std::vector<BlockPlace> places;
  for (const BlockPlace& place : all.Levels[level].Places)
  {
    bool isNear = place.Rank == rank;
    for (int other = 0; other <= all.Finest(); ++other)
    {
      for (const BlockPlace& own : all.Levels[other].Places)
      {
        isNear = isNear || (own.Rank == rank && Meet(own, other, place, level));
      }
    }
    if (isNear)
    {
      places.push_back(place);
    }
  }
  return places;
}

/// Moves a block of a level by a cell or two along an axis, within the grid.
void MoveBlock(DealtBlocks& dealt, RandomDraw& draw)
{
  std::vector<DealtBlocks::Block>& blocks =
    dealt.OfRank[draw.Whole(0, static_cast<int>(dealt.OfRank.size()) - 1)];
  if (!blocks.empty())
  {
    DealtBlocks::Block& block = blocks[draw.Whole(0, static_cast<int>(blocks.size()) - 1)];
    Index3 step{ { 0, 0, 0 } };
    step[draw.Whole(0, 2)] = draw.Whole(-2, 2);
    const IndexBox moved =
      Intersect(Moved(block.Box, step), ChangeLevel(dealt.Global, block.Level));
    block.Box = moved.NumberOfCells() > 0 ? moved : block.Box;
  }
}

} // namespace

TEST(BlockChecks, PlacesAreBlocksWithCommonCells)
{
  for (int count : RankCounts)
  {
    for (int levels : { 1, 3 })
    {
      DealtBlocks dealt = DealBlocks(count, levels, 10 * count + levels);
      RandomDraw draw(count);
      for (int n = 0; n < count; ++n)
      {
        MoveBlock(dealt, draw);
      }
      const InputLevels all = MakeLevels(dealt, -1);
      RunOnRanks(count,
        [&](ThreadRanks& ranks)
        {
          InputLevels input = MakeLevels(dealt, ranks.Rank());
          FindPlaces(input.Levels, ranks);
          EXPECT_EQ(ranks.Sent().GatheredBytes, 0);
          for (int level = 0; level < levels; ++level)
          {
            EXPECT_EQ(
              NamesOf(input.Levels[level].Places), NamesOf(ListPlaces(all, level, ranks.Rank())));
          }
        });
    }
  }
}

TEST(BlockChecks, OverlapsHaveOneMessage)
{
  int overlaps = 0;
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    const int count = RankCounts[1 + seed % 5];
    DealtBlocks dealt = DealBlocks(count, 2, seed);
    RandomDraw draw(seed);
    for (int n = draw.Whole(0, 6); n > 0; --n)
    {
      MoveBlock(dealt, draw);
    }
    const InputLevels all = MakeLevels(dealt, -1);
    std::string expected;
    for (int level = 0; level < 2 && expected.empty(); ++level)
    {
      expected = MessageOf([&] { CheckOverlaps(all.Levels[level].Places, false); });
    }
    overlaps += !expected.empty();
    std::vector<std::string> found(count);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        InputLevels input = MakeLevels(dealt, ranks.Rank());
        FindPlaces(input.Levels, ranks);
        found[ranks.Rank()] = MessageOf([&] { CheckOverlaps(input.Levels, ranks); });
      });
    EXPECT_EQ(found, std::vector<std::string>(count, expected)) << seed;
  }
  EXPECT_GT(overlaps, 10);
  EXPECT_LT(overlaps, 30);
}

TEST(BlockChecks, OverlapNamesBlocksAndCell)
{
  const std::vector<BlockPlace> places{ { { { { 0, 0, 0 } }, { { 4, 4, 4 } } }, 0, 7 },
    { { { { 3, 2, 0 } }, { { 6, 4, 4 } } }, 2, -1 } };
  EXPECT_EQ(MessageOf([&] { CheckOverlaps(places, true); })
              .rfind("Block 7 and The input overlap at cell (3, 2, 0)", 0),
    0u);
  EXPECT_EQ(MessageOf([&] { CheckOverlaps(places, false); })
              .rfind("Block 7 of rank 0 and The input of rank 2 overlap at cell (3, 2, 0)", 0),
    0u);
}

TEST(BlockChecks, GapsHaveOneMessage)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const int count = RankCounts[seed % 6];
    DealtBlocks dealt = DealBlocks(count, 1, seed);
    RandomDraw draw(seed);
    Index missing = 0;
    for (int n = draw.Whole(0, 2); n > 0; --n) // remove blocks
    {
      std::vector<DealtBlocks::Block>& blocks = dealt.OfRank[draw.Whole(0, count - 1)];
      if (!blocks.empty())
      {
        missing += blocks.back().Box.NumberOfCells();
        blocks.pop_back();
      }
    }
    const InputLevels all = MakeLevels(dealt, -1);
    std::vector<bool> isFilled(dealt.Global.NumberOfCells(), false);
    for (const BlockPlace& place : all.Levels[0].Places)
    {
      ForCells(
        place.Box, [&](const Index3& cell) { isFilled[IndexInBox(dealt.Global, cell)] = true; });
    }
    const Index first = std::find(isFilled.begin(), isFilled.end(), false) - isFilled.begin();
    std::vector<std::string> found(count);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const InputLevels input = MakeLevels(dealt, ranks.Rank());
        found[ranks.Rank()] = MessageOf([&] { CheckGaps(input.Levels[0], ranks); });
      });
    EXPECT_EQ(found, std::vector<std::string>(count, found[0]));
    const std::string start = "The blocks leave a gap: " + std::to_string(missing) + " of the " +
      std::to_string(dealt.Global.NumberOfCells()) +
      " cells of their common grid are in no block, the first is ";
    EXPECT_EQ(found[0].empty(), missing == 0);
    if (missing > 0)
    {
      EXPECT_EQ(found[0].rfind(start + TextOf(CellInBox(dealt.Global, first)) + " at (", 0), 0u)
        << found[0];
    }
  }
}

TEST(BlockChecks, IdsOfAllNodes)
{
  InputBlocks input;
  for (std::vector<double>& x : input.Coordinates)
  {
    x.resize(1000);
  }
  EXPECT_EQ(MessageOf([&] { CheckIds(input); }), "");
  for (std::vector<double>& x : input.Coordinates)
  {
    x.resize(900000);
  }
  EXPECT_NE(MessageOf([&] { CheckIds(input); }).find("more than 64-bit ids"), std::string::npos);
}
