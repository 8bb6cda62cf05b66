/**
 * PointTotals: mass, momentum and energy of material points, the same bits in whatever order and on
 * whichever ranks they are.
 */
#pragma once

#include "Domain.h"

#include <array>
#include <vector>

namespace impact
{

/// mg, mg km/s, J.
struct Totals
{
  double Mass = 0.;
  Vector Momentum{};
  double Kinetic = 0., Internal = 0.;
};

/// Sums over the points of each body.
class PointTotals
{
public:
  void Add(const std::vector<MaterialPoint>& points);
  /// Collective.
  std::array<Totals, NumberOfBodies> Sum(const Domain& domain) const;

private:
  static constexpr int Values = 6;
  __extension__ typedef __int128 Integer;
  std::array<std::array<Integer, Values>, NumberOfBodies> Sums{};
};

} // namespace impact
