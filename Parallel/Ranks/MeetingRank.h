/**
 * MeetingRank: the rank where ranks meet that have the same thing, such as a face.
 */
#pragma once

#include <array>
#include <cstdint>

namespace vfm
{

/// Returns one of `count` ranks for a key, from a hash.
template <std::size_t Length>
int MeetingRank(const std::array<std::int64_t, Length>& key, int count)
{
  std::uint64_t hash = 0;
  for (std::int64_t part : key)
  {
    hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return static_cast<int>(hash % static_cast<std::uint64_t>(count));
}

inline int MeetingRank(std::int64_t key, int count)
{
  return MeetingRank(std::array<std::int64_t, 1>{ { key } }, count);
}

} // namespace vfm
