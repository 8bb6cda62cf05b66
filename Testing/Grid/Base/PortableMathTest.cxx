/// Elementary functions that do not depend on the C library.
#include "Base/PortableMath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace vfm;

namespace
{

/// Returns the error of a value in units in its last place.
double UnitsOff(double value, long double truth)
{
  const double next = std::nextafter(std::fabs(static_cast<double>(truth)), INFINITY);
  const long double unit = static_cast<long double>(next) - std::fabs(static_cast<double>(truth));
  return static_cast<double>(std::fabs(static_cast<long double>(value) - truth) / unit);
}

/// Returns the largest error over random arguments from `low` to `high`.
template <class Function, class Truth>
double LargestError(double low, double high, const Function& function, const Truth& truth)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(low, high);
  double largest = 0.0;
  for (int i = 0; i < 200000; ++i)
  {
    const double x = any(random);
    largest = std::max(largest, UnitsOff(function(x), truth(static_cast<long double>(x))));
  }
  return largest;
}

const auto LongExp = [](long double x) { return std::exp(x); };
const auto LongRoot = [](long double x) { return std::cbrt(x); };
const auto LongSine = [](long double x) { return std::sin(x); };
const auto LongCosine = [](long double x) { return std::cos(x); };
const auto LongArc = [](long double x) { return std::atan2(1.0L, x); };

} // namespace

TEST(PortableMath, ErrorsAreAFewUnitsInTheLastPlace)
{
  EXPECT_LT(LargestError(-1.0, 1.0, Exp, LongExp), 1.0);
  EXPECT_LT(LargestError(-700.0, 709.0, Exp, LongExp), 1.0);
  EXPECT_LT(LargestError(-8.0, 8.0, CubeRoot, LongRoot), 1.0);
  EXPECT_LT(LargestError(1e-300, 1e300, CubeRoot, LongRoot), 1.0);
  EXPECT_LT(LargestError(1e-300, 1e-290, CubeRoot, LongRoot), 1.0);
  EXPECT_LT(LargestError(-0.8, 0.8, Sine, LongSine), 2.0);
  EXPECT_LT(LargestError(-0.8, 0.8, Cosine, LongCosine), 2.0);
  EXPECT_LT(LargestError(
              -20.0, 20.0, [](double x) { return ArcTangent(1.0, x); }, LongArc),
    3.0);
}

TEST(PortableMath, LargeAnglesAreAccurate)
{
  const double unit = std::numeric_limits<double>::epsilon();
  const auto check = [unit](double value, long double truth)
  { EXPECT_NEAR(value, static_cast<double>(truth), unit); };
  for (double x = -1e5; x < 1e5; x += 12.345)
  {
    check(Sine(x), LongSine(x));
    check(Cosine(x), LongCosine(x));
  }
}

TEST(PortableMath, ExactValues)
{
  EXPECT_EQ(Exp(0.0), 1.0);
  EXPECT_EQ(Exp(-800.0), 0.0);
  EXPECT_EQ(Exp(800.0), INFINITY);
  EXPECT_TRUE(std::isnan(Exp(NAN)));
  for (int n = -100; n <= 100; ++n)
  {
    EXPECT_EQ(CubeRoot(Cube(n / 8.0)), n / 8.0);
  }
  EXPECT_EQ(Sine(0.0), 0.0);
  EXPECT_EQ(Cosine(0.0), 1.0);
  EXPECT_EQ(ArcTangent(0.0, 1.0), 0.0);
  EXPECT_EQ(ArcTangent(1.0, 0.0), 0.5 * Pi);
  EXPECT_EQ(ArcTangent(-1.0, 1.0), -0.25 * Pi);
  EXPECT_EQ(ArcTangent(0.0, -1.0), Pi);
  EXPECT_EQ(ArcTangent(-0.0, -1.0), -Pi);
}
