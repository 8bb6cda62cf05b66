/**
 * Random numbers from a seed, the same on every machine.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <cmath>
#include <random>

namespace vfm
{
namespace testing
{

class RandomDraw
{
public:
  explicit RandomDraw(unsigned seed) : Engine(seed) {}

  /// Returns a number in (low, high).
  double Between(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine()) + 0.5) / 4294967296.0;
  }
  /// Returns a vector with components in (low, high).
  Vector3 Vector(double low, double high)
  {
    Vector3 v;
    for (double& component : v)
    {
      component = this->Between(low, high);
    }
    return v;
  }
  /// Returns a number in (low, high) with uniform logarithm; 0 < low.
  double Scale(double low, double high)
  {
    return std::exp(this->Between(std::log(low), std::log(high)));
  }
  /// Returns an integer from low to high.
  int Whole(int low, int high)
  {
    return low + static_cast<int>(this->Engine() % static_cast<unsigned>(high - low + 1));
  }
  bool Chance(double share) { return this->Between(0.0, 1.0) < share; }
  /// Returns one of the given values.
  template <class T>
  T Pick(std::initializer_list<T> values)
  {
    return values.begin()[this->Whole(0, static_cast<int>(values.size()) - 1)];
  }
  unsigned Seed() { return static_cast<unsigned>(this->Engine()); }

private:
  std::mt19937 Engine;
};

} // namespace testing
} // namespace vfm
