/// Points in six bytes are bitwise equal to those given.
#include "Smoothing/CodedPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace vfm;

namespace
{

/// Returns points with coordinates of `values` random numbers, the signed zeros among them.
std::vector<double> DrawPoints(std::size_t values, std::size_t points)
{
  std::mt19937_64 engine(values);
  std::vector<double> all(values);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  std::generate(all.begin(), all.end(), [&] { return draw(engine); });
  all[0] = 0.0;
  all[1] = -0.0;
  std::vector<double> result;
  for (std::size_t p = 0; p < points; ++p)
  {
    for (int a = 0; a < 3; ++a)
    {
      result.push_back(all[(p + a * 7) % values]);
    }
  }
  return result;
}

TEST(CodedPoints, AreThoseGiven)
{
  const std::vector<double> points = DrawPoints(1000, 3000);
  const std::vector<int> list{ 2999, 0, 1, 17, 1500, 17, 994 };
  const CodedPoints coded(points.data(), list);
  ASSERT_EQ(coded.Count(), list.size());
  for (std::size_t p = 0; p < list.size(); ++p)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double x = points[3 * list[p] + a];
      EXPECT_EQ(coded.At(p)[a], x);
      EXPECT_EQ(std::signbit(coded.At(p)[a]), std::signbit(x));
    }
  }
}

TEST(CodedPoints, AreConverted)
{
  const std::vector<double> points = DrawPoints(50, 100);
  CodedPoints coded(points.data(), { 3, 99 });
  coded.Convert([](int a, double x) { return (x - a) / 0.3; });
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_EQ(coded.ConvertedAt(1)[a], (points[3 * 99 + a] - a) / 0.3);
    EXPECT_EQ(coded.At(1)[a], points[3 * 99 + a]);
  }
}

TEST(CodedPoints, HaveALimitedNumberOfValues)
{
  for (std::size_t more : { 0, 1 })
  {
    const std::size_t count = CodedPoints::MaximumValues + more;
    const std::vector<double> points = DrawPoints(count, count);
    std::vector<int> list(count);
    for (std::size_t p = 0; p < count; ++p)
    {
      list[p] = static_cast<int>(p);
    }
    EXPECT_EQ(CodedPoints(points.data(), list).IsEmpty(), more > 0);
  }
}

} // namespace
