/// Sums that do not depend on the order of their summands or on ranks.
#include "Base/ExactSum.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns numbers of either sign with magnitudes between 2^-10 and 2^10.
std::vector<double> MakeNumbers(int count)
{
  std::mt19937 random(7);
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i)
  {
    const double mantissa = random() * 0x1p-32 + 0.5;
    numbers.push_back(std::ldexp(random() % 2 ? mantissa : -mantissa, int(random() % 20) - 10));
  }
  return numbers;
}

long double SumLong(const std::vector<double>& numbers)
{
  long double sum = 0.0L;
  for (double number : numbers)
  {
    sum += number;
  }
  return sum;
}

template <class Iterator>
ExactSum SumOf(Iterator first, Iterator last)
{
  ExactSum sum;
  for (; first != last; ++first)
  {
    sum.Add(*first);
  }
  return sum;
}

} // namespace

// Many equal summands: a systematic error of each would show.
TEST(ExactSum, KeepsTheBitsOfManyEqualSummands)
{
  for (double value : { 1.0 / 12.0, -1.0 / 12.0, 1e-3 / 7.0, 0.1, 1e9 / 3.0 })
  {
    constexpr int count = 100000;
    const std::vector<double> values(count, value);
    EXPECT_DOUBLE_EQ(SumOf(values.begin(), values.end()).Value(), count * value);
    ExactSum product;
    product.Add(value, count);
    EXPECT_DOUBLE_EQ(product.Value(), count * value);
  }
}

TEST(ExactSum, RoundsTheLastBit)
{
  const auto valueOf = [](double value)
  {
    ExactSum sum;
    sum.Add(value);
    return sum.Value();
  };
  constexpr double unit = 0x1p-70;
  EXPECT_EQ(valueOf(0.75 * unit), unit);
  EXPECT_EQ(valueOf(-0.75 * unit), -unit);
  EXPECT_EQ(valueOf(0.25 * unit), 0.0);
  EXPECT_EQ(valueOf(-0.25 * unit), 0.0);
  for (double value : { 0x1.fffffffffffffp42, -0x1.fffffffffffffp42, 0x1.fffffffffffffp55, 0x1p41 })
  {
    EXPECT_EQ(valueOf(value), value);
  }
}

TEST(ExactSum, IsTheSameInAnyOrderAndOnRanks)
{
  const std::vector<double> numbers = MakeNumbers(1000);
  const double sum = SumOf(numbers.begin(), numbers.end()).Value();
  EXPECT_NEAR(sum, static_cast<double>(SumLong(numbers)), 1e-12);
  EXPECT_EQ(SumOf(numbers.rbegin(), numbers.rend()).Value(), sum);
  for (int ranks : { 2, 3, 8 })
  {
    RunOnRanks(ranks,
      [&](Ranks& group)
      {
        ExactSum mine;
        for (std::size_t i = group.Rank(); i < numbers.size(); i += ranks)
        {
          mine.Add(numbers[i]);
        }
        EXPECT_EQ(SumOverRanks(std::vector<ExactSum>{ mine }, group)[0], sum);
      });
  }
}
