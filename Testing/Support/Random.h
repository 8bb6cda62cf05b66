/**
 * Numbers drawn at random, the same with every library: what std::uniform_real_distribution gives is not.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <random>

namespace vfm
{
namespace testing
{

class Random
{
public:
  double operator()(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine()) + 0.5) / 4294967296.0;
  }
  /// Each component from -size to size.
  Vector3 Vector(double size)
  {
    const double x = (*this)(-size, size), y = (*this)(-size, size);
    return { { x, y, (*this)(-size, size) } };
  }

private:
  std::mt19937 Engine{ 1 };
};

} // namespace testing
} // namespace vfm
