#include "Volumes/LargeIsland.h"

#include "Base/PairSums.h"

namespace vfm
{
namespace
{

constexpr int LargestIterations = 1000; // reached only if areas differ by 1e18

IslandLevel MakeFirstLevel(FragmentShare share, std::vector<FragmentPair> pairs)
{
  IslandLevel level;
  level.Pairs = PairShare(share, std::move(pairs));
  level.Regular.assign(share.Size(), RegularDiagonal);
  level.Share = std::move(share);
  return level;
}

/// Returns a power of two near the largest absolute value, or 0 if there is none. It keeps the bits
/// of values that it divides, and exact sums of them in their range.
double FindUnit(const std::vector<double>& values, Ranks& ranks)
{
  double largest = 0.0;
  for (std::size_t f = 1; f < values.size(); ++f)
  {
    largest = std::max(largest, std::fabs(values[f]));
  }
  largest = ranks.Max(largest);
  return largest > 0.0 ? std::ldexp(1.0, std::ilogb(largest)) : 0.0;
}

} // namespace

LargeIsland::LargeIsland(
  FragmentShare share, std::vector<FragmentPair> pairs, const std::vector<double>& areas) :
  Levels(MakeFirstLevel(std::move(share), std::move(pairs)), areas)
{
}

std::vector<double> LargeIsland::Solve(
  const std::vector<double>& areas, const std::vector<double>& lack, int* iterations) const
{
  const IslandLevel& level = this->Levels.First();
  const FragmentShare& share = level.Share;
  std::vector<double> x(lack.size(), 0.0), rest(lack), before, direction(x);
  const double unit = FindUnit(lack, *share.Group);
  int iteration = 0;
  if (unit > 0.0)
  {
    const IslandLevels::System system = this->Levels.MakeSystem(areas);
    rest[0] = 0.0;
    std::for_each(rest.begin(), rest.end(), [unit](double& value) { value /= unit; });
    const double end = Tolerance * Tolerance * Dot(share, rest, rest);
    double last = 1.0;
    for (; iteration < LargestIterations && Dot(share, rest, rest) > end; ++iteration)
    {
      // The approximate solver is not linear: directions are made orthogonal by differences
      // (Polak, Ribiere).
      const std::vector<double> correction = this->Levels.Approximate(system, rest);
      const double next = Dot(share, correction, rest);
      const double turn = iteration == 0 ? 0.0 : (next - Dot(share, correction, before)) / last;
      for (std::size_t f = 1; f < x.size(); ++f)
      {
        direction[f] = correction[f] + turn * direction[f];
      }
      const std::vector<double> product = Multiply(level, system.Values[0], direction);
      const double square = Dot(share, direction, product);
      if (!(next > 0.0 && square > 0.0))
      {
        break; // all that rounding leaves
      }
      before = rest;
      AddTimes(next / square, direction, x);
      AddTimes(-next / square, product, rest);
      last = next;
    }
    std::for_each(x.begin(), x.end(), [unit](double& value) { value *= unit; });
  }
  if (iterations)
  {
    *iterations = iteration;
  }
  return x;
}

} // namespace vfm
