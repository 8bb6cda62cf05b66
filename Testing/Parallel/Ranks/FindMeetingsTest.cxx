/// Boxes of different ranks that meet, found by tiles, against all pairs of boxes.
#include "Ranks/FindMeetings.h"
#include "Ranks/BoxTiles.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const int RankCounts[] = { 1, 2, 3, 4, 5, 8, 12, 27, 64 };

struct Box
{
  std::array<std::int64_t, 3> Lower, Upper;

  bool HasCells() const
  {
    return this->Lower[0] < this->Upper[0] && this->Lower[1] < this->Upper[1] &&
      this->Lower[2] < this->Upper[2];
  }
};

/// A box that is given in two parts along x.
struct Parted
{
  Box Whole;
  std::int64_t Cut;
};

bool Meet(const Box& a, const Box& b)
{
  Box common;
  for (int axis = 0; axis < 3; ++axis)
  {
    common.Lower[axis] = std::max(a.Lower[axis], b.Lower[axis]);
    common.Upper[axis] = std::min(a.Upper[axis], b.Upper[axis]);
  }
  return common.HasCells();
}

/// How boxes are drawn.
enum class Sizes
{
  Equal,   ///< one box per rank, equal sizes
  Any,     ///< up to 5 boxes per rank, sizes from 1 to 1,000 along each axis
  OneHuge, ///< one box of rank 0 around small ones of the others; some ranks have none
  Flat     ///< plates and needles across all space
};

Box Draw(std::mt19937& random, const Box& space, int largest)
{
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t width = space.Upper[axis] - space.Lower[axis];
    box.Lower[axis] = space.Lower[axis] + static_cast<std::int64_t>(random()) % width;
    box.Upper[axis] = box.Lower[axis] + 1 + static_cast<std::int64_t>(random()) % largest;
  }
  return box;
}

std::vector<Box> BoxesOfRank(Sizes sizes, int rank, int count)
{
  std::mt19937 random(1000 * count + rank);
  const std::int64_t side = static_cast<std::int64_t>(30 * std::cbrt(count)) + 1;
  const Box space{ { { -side, -side, -side } }, { { side, side, side } } };
  std::vector<Box> boxes;
  if (sizes == Sizes::OneHuge)
  {
    boxes.push_back(rank == 0 ? space : Draw(random, space, 9));
    if (rank % 3 == 2)
    {
      boxes.clear();
    }
    return boxes;
  }
  const int number = sizes == Sizes::Equal ? 1 : static_cast<int>(random() % 6);
  for (int n = 0; n < number; ++n)
  {
    const int scales[] = { 1, 10, 100, 1000 };
    Box box = Draw(random, space, sizes == Sizes::Any ? scales[random() % 4] : 5);
    for (int axis = 0; axis < 3 && sizes == Sizes::Equal; ++axis)
    {
      box.Upper[axis] = box.Lower[axis] + 60;
    }
    if (sizes == Sizes::Flat)
    {
      const int axis = static_cast<int>(random() % 3);
      box.Lower[axis] = space.Lower[axis];
      box.Upper[axis] = space.Upper[axis];
    }
    boxes.push_back(box);
  }
  return boxes;
}

std::vector<std::array<int, 2>> Places(const std::vector<RankItem<Box>>& items)
{
  std::vector<std::array<int, 2>> places;
  for (const RankItem<Box>& item : items)
  {
    places.push_back({ { item.Rank, item.Number } });
  }
  return places;
}

std::array<Box, 1> OneBox(const Box& box)
{
  return { { box } };
}

} // namespace

TEST(FindMeetings, EqualToAllPairs)
{
  for (Sizes sizes : { Sizes::Equal, Sizes::Any, Sizes::OneHuge, Sizes::Flat })
  {
    std::size_t found = 0;
    for (int count : RankCounts)
    {
      std::vector<std::size_t> founds(count);
      RunOnRanks(count,
        [&](Ranks& ranks)
        {
          const std::vector<Box> own = BoxesOfRank(sizes, ranks.Rank(), count);
          std::vector<std::array<int, 2>> expected;
          for (int rank = 0; rank < count; ++rank)
          {
            const std::vector<Box> boxes = BoxesOfRank(sizes, rank, count);
            for (std::size_t b = 0; rank != ranks.Rank() && b < boxes.size(); ++b)
            {
              if (std::any_of(
                    own.begin(), own.end(), [&](const Box& box) { return Meet(box, boxes[b]); }))
              {
                expected.push_back({ { rank, static_cast<int>(b) } });
              }
            }
          }
          const std::vector<RankItem<Box>> items = FindMeetings(own, OneBox, Meet, ranks);
          EXPECT_EQ(Places(items), expected) << count;
          for (const RankItem<Box>& item : items)
          {
            EXPECT_EQ(item.What.Lower, BoxesOfRank(sizes, item.Rank, count)[item.Number].Lower);
          }
          founds[ranks.Rank()] = items.size();
        });
      for (std::size_t number : founds)
      {
        found += number;
      }
    }
    EXPECT_GT(found, 60u); // the cases have boxes that meet
  }
}

TEST(FindMeetings, ItemsOfSeveralBoxesMeetOnce)
{
  const int count = 12;
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const auto itemOf = [](int rank)
      {
        const std::int64_t x = 7 * rank;
        return Parted{ { { { x, 0, 0 } }, { { x + 30, 4, 4 } } }, x + 11 };
      };
      const auto boxesOf = [](const Parted& item)
      {
        Box low = item.Whole, high = item.Whole;
        low.Upper[0] = high.Lower[0] = item.Cut;
        return std::vector<Box>{ low, high };
      };
      const auto meet = [](const Parted& a, const Parted& b) { return Meet(a.Whole, b.Whole); };
      std::vector<int> expected, found;
      for (int rank = 0; rank < count; ++rank)
      {
        if (rank != ranks.Rank() && meet(itemOf(rank), itemOf(ranks.Rank())))
        {
          expected.push_back(rank);
        }
      }
      for (const RankItem<Parted>& item :
        FindMeetings(std::vector<Parted>{ itemOf(ranks.Rank()) }, boxesOf, meet, ranks))
      {
        found.push_back(item.Rank);
        EXPECT_EQ(item.What.Cut, itemOf(item.Rank).Cut);
      }
      EXPECT_EQ(found, expected);
    });
}

TEST(FindMeetings, NoItemsAtAll)
{
  RunOnRanks(5,
    [](Ranks& ranks)
    { EXPECT_TRUE(FindMeetings(std::vector<Box>(), OneBox, Meet, ranks).empty()); });
}

TEST(FindMeetings, BytesOfARankDoNotGrowWithRanks)
{
  // Boxes of equal size side by side: a rank has two neighbours, whatever the number of ranks.
  std::vector<std::int64_t> most;
  for (int count : { 16, 64 })
  {
    std::vector<std::int64_t> bytes(count);
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        const std::int64_t x = 10 * ranks.Rank();
        const Box box{ { { x - 1, 0, 0 } }, { { x + 11, 10, 10 } } };
        EXPECT_LE(FindMeetings(std::vector<Box>{ box }, OneBox, Meet, ranks).size(), 2u);
        EXPECT_EQ(ranks.Sent().GatheredBytes, 0);
        bytes[ranks.Rank()] = ranks.Sent().MessageBytes;
      });
    most.push_back(*std::max_element(bytes.begin(), bytes.end()));
  }
  EXPECT_LT(most[1], 3 * most[0]);
}

TEST(BoxTiles, BoxesMeetFewTilesOfTheirLevel)
{
  RunOnRanks(3,
    [](Ranks& ranks)
    {
      // most boxes are plates of 100 x 100 x 3 cells; rank 2 also has a large cube
      std::vector<BoxTiles::Position> sizes(20, BoxTiles::Position{ { 100, 100, 3 } });
      const BoxTiles::Position cube{ { 5000, 5000, 5000 } };
      if (ranks.Rank() == 2)
      {
        sizes.push_back(cube);
      }
      const BoxTiles tiles(sizes, ranks);
      EXPECT_EQ(tiles.LevelOf({ { 100, 100, 3 } }), 0);
      EXPECT_EQ(tiles.LevelOf({ { 1, 1, 1 } }), 0);
      EXPECT_EQ(tiles.LevelOf(cube), 11); // 4 * 2^11 cells along z
      for (std::int64_t x : { -1000, -1, 0, 77 })
      {
        int lowest = 0, other = 0;
        const Box plate{ { { x, x, x } }, { { x + 100, x + 100, x + 3 } } };
        tiles.ForTiles(
          0, plate, [&](const BoxTiles::Tile& tile) { ++(tile[0] == 0 ? lowest : other); });
        EXPECT_LE(lowest, 8);
        EXPECT_GE(lowest, 1);
        EXPECT_GE(other, 2); // at the levels of the cube along z and along other axes
        EXPECT_LE(other, 16);
      }
      EXPECT_EQ(tiles.TileOf(0, { { -1, 0, 0 } }), (BoxTiles::Tile{ { 0, -1, 0, 0 } }));
    });
}
