/**
 * Disjoint sets of 0..n-1 as a forest of parents; at the start every item is its own.
 */
#pragma once

#include "Base/IndexBox.h"

#include <numeric>

namespace vfm
{

inline std::vector<Index> MakeSets(std::size_t count)
{
  std::vector<Index> parent(count);
  std::iota(parent.begin(), parent.end(), 0);
  return parent;
}

inline Index FindRoot(std::vector<Index>& parent, Index item)
{
  while (parent[item] != item)
  {
    parent[item] = parent[parent[item]];
    item = parent[item];
  }
  return item;
}

/// The lower root wins, so a root is the lowest item of its set.
inline void Join(std::vector<Index>& parent, Index a, Index b)
{
  a = FindRoot(parent, a);
  b = FindRoot(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
}

} // namespace vfm
