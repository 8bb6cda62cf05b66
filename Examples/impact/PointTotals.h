/**
 * PointTotals: mass, momentum and energy of material points. The sums are bitwise identical for any
 * order of the points and any distribution over ranks.
 */
#pragma once

#include "Domain.h"

#include <array>
#include <vector>

namespace impact
{

/// Totals of one body, in mg, mg km/s and J.
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
  /// Returns the totals of each body over all ranks.
  /// @pre Collective
  std::array<Totals, NumberOfBodies> Sum(const Domain& domain) const;

private:
  static constexpr int Values = 6;
  __extension__ typedef __int128 Integer;
  std::array<std::array<Integer, Values>, NumberOfBodies> Sums{};
};

} // namespace impact
