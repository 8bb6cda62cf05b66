/// Items from ranks to ranks and answers back, on ranks that are threads.
#include "Ranks/ItemRoute.h"
#include "Ranks/WorkTogether.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const int RankCounts[] = { 1, 2, 3, 4, 5, 6, 7, 8, 12, 27 };

enum class Case
{
  Random,    ///< every third rank sends nothing
  AllToLast, ///< the last rank gets all
  Near       ///< to the next two ranks
};

/// Returns the ranks that get the items of a rank.
std::vector<int> ReceiversOf(int rank, int count, Case kind)
{
  std::mt19937 random(100 * count + rank);
  std::vector<int> to;
  for (int i = 0; rank % 3 != 1 && i < 40; ++i)
  {
    const int any = static_cast<int>(random() % count);
    to.push_back(kind == Case::Random ? any
        : kind == Case::AllToLast     ? count - 1
                                      : (rank + 1 + any % 2) % count);
  }
  return to;
}

struct Item
{
  int Source, Place, To;
  bool operator==(const Item& other) const
  {
    return this->Source == other.Source && this->Place == other.Place && this->To == other.To;
  }
};

std::vector<Item> ItemsOf(int rank, const std::vector<int>& to)
{
  std::vector<Item> items;
  for (int receiver : to)
  {
    items.push_back({ rank, static_cast<int>(items.size()), receiver });
  }
  return items;
}

int CountBits(int count)
{
  int bits = 0;
  while (1 << (bits + 1) <= count)
  {
    ++bits;
  }
  return bits;
}

} // namespace

TEST(ItemRoute, ItemsComeByRankAndThenAsSent)
{
  for (int count : RankCounts)
  {
    for (Case kind : { Case::Random, Case::AllToLast, Case::Near })
    {
      RunOnRanks(count,
        [count, kind](ThreadRanks& ranks)
        {
          std::vector<Item> expected;
          for (int source = 0; source < count; ++source)
          {
            for (const Item& item : ItemsOf(source, ReceiversOf(source, count, kind)))
            {
              if (item.To == ranks.Rank())
              {
                expected.push_back(item);
              }
            }
          }
          const std::vector<int> to = ReceiversOf(ranks.Rank(), count, kind);
          const std::vector<Item> items = ItemsOf(ranks.Rank(), to);
          ItemRoute route(to, ranks);
          const std::vector<Item> received = route.Send(items);
          EXPECT_EQ(received, expected) << count << ", rank " << ranks.Rank();
          std::vector<int> sources;
          for (const ItemRoute::Run& run : route.Received())
          {
            EXPECT_EQ(run.To, ranks.Rank());
            sources.insert(sources.end(), run.Count, run.Source);
          }
          ASSERT_EQ(sources.size(), received.size());
          std::vector<std::array<std::int64_t, 2>> answers;
          for (std::size_t i = 0; i < received.size(); ++i)
          {
            EXPECT_EQ(sources[i], received[i].Source);
            answers.push_back({ { ranks.Rank(), 1000 * received[i].Source + received[i].Place } });
          }
          const auto own = route.Return(answers);
          ASSERT_EQ(own.size(), items.size());
          for (std::size_t i = 0; i < items.size(); ++i)
          {
            EXPECT_EQ(own[i][0], to[i]);
            EXPECT_EQ(own[i][1], 1000 * ranks.Rank() + static_cast<int>(i));
          }
        });
    }
  }
}

TEST(ItemRoute, MessagesGrowWithTheLogarithmOfRanks)
{
  for (int count : { 1, 2, 3, 8, 27, 32 })
  {
    for (Case kind : { Case::Random, Case::AllToLast })
    {
      RunOnRanks(count,
        [count, kind](ThreadRanks& ranks)
        {
          const std::vector<int> to = ReceiversOf(ranks.Rank(), count, kind);
          ItemRoute route(to, ranks);
          const std::vector<Item> received = route.Send(ItemsOf(ranks.Rank(), to));
          EXPECT_LE(ranks.Sent().Messages, CountBits(count) + 2);
          route.Return(received);
          EXPECT_LE(ranks.Sent().Messages, 2 * (CountBits(count) + 2));
          EXPECT_EQ(ranks.Sent().GatheredBytes, 0);
          EXPECT_EQ(ranks.Sent().Reductions, 0);
        });
    }
  }
}

/// An item crosses at most one edge per bit, and two more from or to a rank beyond the hypercube.
TEST(ItemRoute, BytesGrowWithTheLogarithmOfRanks)
{
  for (int count : { 8, 27, 32 })
  {
    RunOnRanks(count,
      [count](ThreadRanks& ranks)
      {
        const std::vector<int> to(1000, (ranks.Rank() + 1) % count);
        ItemRoute(to, ranks).Send(std::vector<double>(to.size(), 1.0));
        std::vector<std::int64_t> bytes{ ranks.Sent().MessageBytes };
        ranks.Sum(bytes);
        const std::int64_t runs = 40 * count * (CountBits(count) + 2);
        EXPECT_LE(bytes[0], 8000 * count * (CountBits(count) + 2) + runs);
      });
  }
}

/// A rank that fails between the items and the answers stops the ranks that wait for answers.
TEST(ItemRoute, ARankFailsBeforeItAnswers)
{
  for (int count : { 1, 2, 3, 8, 12, 27 })
  {
    const int faulty = count - 1;
    RunOnRanks(count,
      [count, faulty](ThreadRanks& ranks)
      {
        const std::vector<int> to = ReceiversOf(ranks.Rank(), count, Case::Random);
        for (bool fails : { true, false, true }) // the ranks can be used again
        {
          std::string message;
          try
          {
            WorkTogether(ranks,
              [&]
              {
                ItemRoute route(to, ranks);
                const std::vector<Item> received = route.Send(ItemsOf(ranks.Rank(), to));
                if (fails && ranks.Rank() == faulty)
                {
                  throw InputError("No answers.");
                }
                EXPECT_EQ(route.Return(received), ItemsOf(ranks.Rank(), to));
              });
          }
          catch (const InputError& error)
          {
            message = error.what();
          }
          EXPECT_EQ(message, fails ? "No answers." : "");
        }
      });
  }
}
