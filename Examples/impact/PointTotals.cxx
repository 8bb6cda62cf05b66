#include "PointTotals.h"

namespace impact
{
namespace
{

constexpr double Quanta = 0x1p70; // number of quanta per unit
constexpr int LowBits = 40;       // ranks sum two numbers: these low bits, and the others

} // namespace

void PointTotals::Add(const std::vector<MaterialPoint>& points)
{
  for (const MaterialPoint& p : points)
  {
    const Vector& v = p.Velocity;
    const double mass = p.Mass();
    const double values[Values] = { mass, mass * v[0], mass * v[1], mass * v[2],
      .5 * mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), mass * p.Energy };
    for (int i = 0; i < Values; ++i)
    {
      this->Sums[p.Owner][i] += static_cast<Integer>(values[i] * Quanta);
    }
  }
}

std::array<Totals, NumberOfBodies> PointTotals::Sum(const Domain& domain) const
{
  constexpr Integer one = 1;
  std::array<Totals, NumberOfBodies> totals;
  for (int body = 0; body < NumberOfBodies; ++body)
  {
    double sums[Values];
    for (int i = 0; i < Values; ++i)
    {
      const Integer mine = this->Sums[body][i];
      const Integer high = domain.Sum(static_cast<std::int64_t>(mine >> LowBits));
      const Integer low = domain.Sum(static_cast<std::int64_t>(mine & ((one << LowBits) - 1)));
      sums[i] = static_cast<double>(high * (one << LowBits) + low) / Quanta;
    }
    totals[body] = { sums[0], { sums[1], sums[2], sums[3] }, sums[4], sums[5] };
  }
  return totals;
}

} // namespace impact
