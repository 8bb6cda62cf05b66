#include "Ranks/BoxTiles.h"

namespace vfm
{

BoxTiles::BoxTiles(const std::vector<Position>& sizes, Ranks& ranks)
{
  std::vector<std::int64_t> counts(3 * Exponents, 0); // of boxes by exponent along each axis
  for (const Position& size : sizes)
  {
    for (int a = 0; a < 3; ++a)
    {
      ++counts[a * Exponents + ExponentOf(size[a])];
    }
  }
  ranks.Sum(counts);
  this->IsUsed[0] = true;
  for (int a = 0; a < 3; ++a)
  {
    const std::int64_t* count = counts.data() + static_cast<std::ptrdiff_t>(a * Exponents);
    std::int64_t all = 0, fit = 0;
    std::for_each(count, count + Exponents, [&all](std::int64_t n) { all += n; });
    int& lowest = this->Lowest[a];
    for (lowest = 0; 2 * (fit += count[lowest]) < all; ++lowest)
    {
    }
    if (lowest + 1 < Exponents && 8 * count[lowest + 1] > all) // two levels would cost more
    {
      ++lowest;
    }
    for (int e = lowest + 1; e < Exponents; ++e)
    {
      this->IsUsed[e - lowest] = this->IsUsed[e - lowest] || count[e] > 0;
    }
  }
}

int BoxTiles::LevelOf(const Position& size) const
{
  int level = 0;
  for (int a = 0; a < 3; ++a)
  {
    level = std::max(level, ExponentOf(size[a]) - this->Lowest[a]);
  }
  return level;
}

/// Returns the least exponent whose power of two is at least a size.
int BoxTiles::ExponentOf(std::int64_t size)
{
  int exponent = 0;
  while (exponent + 1 < Exponents && (std::int64_t(1) << exponent) < size)
  {
    ++exponent;
  }
  return exponent;
}

} // namespace vfm
