#include "Ranks/AskRanks.h"

#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(AskRanks, AnswersBelongToTheItems)
{
  for (int count : { 1, 2, 5, 12 })
  {
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        std::vector<std::int64_t> items; // none on the first rank
        for (int i = 0; i < 7 * ranks.Rank(); ++i)
        {
          items.push_back(100 * ranks.Rank() + (5 * i) % 7);
        }
        const auto rankOf = [count](std::int64_t item) { return static_cast<int>(item % count); };
        const auto answer = [&](const std::vector<std::int64_t>& received)
        {
          std::vector<std::array<std::int64_t, 2>> answers;
          for (std::int64_t item : received)
          {
            EXPECT_EQ(rankOf(item), ranks.Rank());
            answers.push_back({ { item, ranks.Rank() } });
          }
          return answers;
        };
        const auto answers = AskRanks(items, rankOf, answer, ranks);
        ASSERT_EQ(answers.size(), items.size());
        for (std::size_t i = 0; i < items.size(); ++i)
        {
          EXPECT_EQ(answers[i], (std::array<std::int64_t, 2>{ { items[i], rankOf(items[i]) } }));
        }
      });
  }
}
