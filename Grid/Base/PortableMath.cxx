#include "Base/PortableMath.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace vfm
{
namespace
{

/// Returns c[0] + c[1] x + c[2] x^2 + ...
template <std::size_t count>
double Polynomial(const double (&c)[count], double x)
{
  double sum = c[count - 1];
  for (std::size_t i = count - 1; i-- > 0;)
  {
    sum = c[i] + x * sum;
  }
  return sum;
}

// Coefficients of the series of (exp(r) - 1 - r) / r^2, in even and odd powers of r.
constexpr double ExpEven[] = { 1.0 / 2, 1.0 / 24, 1.0 / 720, 1.0 / 40320, 1.0 / 3628800,
  1.0 / 479001600, 1.0 / 87178291200 };
constexpr double ExpOdd[] = { 1.0 / 6, 1.0 / 120, 1.0 / 5040, 1.0 / 362880, 1.0 / 39916800,
  1.0 / 6227020800 };

// Series of (sin(r) - r) / r^3 and (cos(r) - 1) / r^2 in powers of r^2.
constexpr double SineSeries[] = { -1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800,
  1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000 };
constexpr double CosineSeries[] = { -1.0 / 2, 1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800,
  1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000 };

// Series of (atan(r) - r) / r^3 in powers of r^2, and atan(k / 8).
constexpr double ArcSeries[] = { -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13 };
constexpr double ArcTable[] = { 0.0, 0.12435499454676143503, 0.24497866312686415417,
  0.35877067027057222040, 0.46364760900080611621, 0.55859931534356243597, 0.64350110879328438680,
  0.71882999962162450542, 0.78539816339744830962 };

// Constants in parts. The first parts have so few bits that multiples of them are exact.
constexpr double Ln2[] = { 6.93147180369123816490e-01, 1.90821492927058770002e-10 };
constexpr double HalfPi[] = { 1.57079632673412561417, 6.07710050630396597660e-11,
  2.02226624879595063154e-21 };

constexpr double PiRest = 1.22464679914735317636e-16; // Pi of the mathematics minus the constant

double SineOf(double r)
{
  const double square = r * r;
  return r + r * square * Polynomial(SineSeries, square);
}

double CosineOf(double r)
{
  const double square = r * r;
  return 1.0 + square * Polynomial(CosineSeries, square);
}

/// Returns x * 2^power; x is near 1.
double TimesPower(double x, int power)
{
  constexpr int bias = 1023, digits = 52, largest = 1000; // beyond, the result may be rounded
  return std::abs(power) > largest
    ? std::ldexp(x, power)
    : x * std::bit_cast<double>(static_cast<std::uint64_t>(power + bias) << digits);
}

constexpr double MostTurns = 2147483000.0; // quarter turns that an int holds

/// Returns the sine of x + quarters * Pi / 2.
double SineOfQuarter(double x, int quarters)
{
  const double turns = std::floor(x * (2.0 / Pi) + 0.5);
  const double r = ((x - turns * HalfPi[0]) - turns * HalfPi[1]) - turns * HalfPi[2];
  const int whole = std::fabs(turns) < MostTurns ? static_cast<int>(turns) : 0; // not for NaN
  const int quarter = (whole + quarters) & 3;
  const double value = quarter % 2 == 0 ? SineOf(r) : CosineOf(r);
  return quarter < 2 ? value : -value;
}

/// Returns the arc tangent of a value in [0, 1].
double ArcTangentOf(double x)
{
  const int place = static_cast<int>(8.0 * x + 0.5);
  const double middle = place / 8.0;
  const double r = (x - middle) / (1.0 + x * middle);
  const double square = r * r;
  return ArcTable[place] + (r + r * square * Polynomial(ArcSeries, square));
}

} // namespace

double Exp(double x)
{
  constexpr double largest = 709.782712893384, smallest = -745.2;
  if (!(x <= largest))
  {
    return x > largest ? std::numeric_limits<double>::infinity() : x;
  }
  if (x < smallest)
  {
    return 0.0;
  }
  const double power = std::floor(x / (Ln2[0] + Ln2[1]) + 0.5);
  const double r = (x - power * Ln2[0]) - power * Ln2[1], square = r * r;
  const double series = Polynomial(ExpEven, square) + r * Polynomial(ExpOdd, square);
  return TimesPower(1.0 + (r + square * series), static_cast<int>(power));
}

double CubeRoot(double x)
{
  if (x == 0.0 || !std::isfinite(x))
  {
    return x;
  }
  int exponent = 0;
  const double fraction = std::frexp(std::fabs(x), &exponent); // in [1/2, 1)
  const int third = exponent >= 0 ? exponent / 3 : -((2 - exponent) / 3);
  const double reduced = std::ldexp(fraction, exponent - 3 * third); // in [1/2, 4)
  double root = 0.65 + 0.25 * reduced;
  for (int step = 0; step < 6; ++step)
  {
    root -= (Cube(root) - reduced) / (3.0 * root * root);
  }
  return std::copysign(std::ldexp(root, third), x);
}

double Sine(double x)
{
  return SineOfQuarter(x, 0);
}

double Cosine(double x)
{
  return SineOfQuarter(x, 1);
}

double ArcTangent(double y, double x)
{
  const double height = std::fabs(y), width = std::fabs(x);
  if (height == 0.0 && width == 0.0)
  {
    return std::copysign(std::signbit(x) ? Pi : 0.0, y);
  }
  double angle = height <= width ? ArcTangentOf(height / width)
                                 : 0.5 * Pi - (ArcTangentOf(width / height) - 0.5 * PiRest);
  angle = std::signbit(x) ? Pi - (angle - PiRest) : angle;
  return std::copysign(angle, y);
}

} // namespace vfm
