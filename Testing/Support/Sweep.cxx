#include "Sweep.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

namespace vfm
{
namespace testing
{

namespace
{

/// Returns the value of VFM_SWEEP, default 1.
double ReadFactor()
{
  const char* text = std::getenv("VFM_SWEEP");
  char* end = nullptr;
  const double factor = text ? std::strtod(text, &end) : 1.0;
  if (text && (end == text || *end || !(factor > 0.0 && factor <= 1e6)))
  {
    throw std::invalid_argument("VFM_SWEEP must be a positive factor up to 1e6");
  }
  return factor;
}

/// Reads VFM_SEEDS; returns whether it is set.
bool ReadRange(unsigned& first, unsigned& count)
{
  const char* text = std::getenv("VFM_SEEDS");
  if (text && std::sscanf(text, "%u:%u", &first, &count) != 2)
  {
    throw std::invalid_argument("VFM_SEEDS must be first:count");
  }
  return text != nullptr;
}

} // namespace

std::vector<unsigned> ListSeeds(unsigned count, unsigned part, unsigned parts)
{
  unsigned first = 0;
  if (!ReadRange(first, count))
  {
    count = std::max(parts, static_cast<unsigned>(count * ReadFactor()));
  }
  const unsigned lower = count * part / parts, upper = count * (part + 1) / parts;
  std::vector<unsigned> seeds(upper - lower);
  std::iota(seeds.begin(), seeds.end(), first + lower);
  return seeds;
}

bool IsWholeSweep()
{
  return !std::getenv("VFM_SEEDS") && ReadFactor() >= 1.0;
}

} // namespace testing
} // namespace vfm
