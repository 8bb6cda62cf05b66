/**
 * SiteDraw: random numbers of a site that any rank can draw, in any order.
 */
#pragma once

#include <cstdint>

namespace vfm
{
namespace testing
{

/// Returns random bits that depend only on the site and on which of its numbers it is, below 8.
inline std::uint64_t DrawBits(std::int64_t site, int which)
{
  std::uint64_t x = static_cast<std::uint64_t>(site) * 8 + which + 12345;
  x = (x ^ (x >> 31)) * 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 29)) * 0xbf58476d1ce4e5b9U;
  return x ^ (x >> 32);
}

/// Returns a number in [0, 1).
inline double DrawNumber(std::int64_t site, int which)
{
  return static_cast<double>(DrawBits(site, which) >> 11) * 0x1p-53;
}

} // namespace testing
} // namespace vfm
