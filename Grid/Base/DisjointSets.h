/**
 * Disjoint sets of the items 0 to n-1 (union-find), stored as the parent of each item.
 */
#pragma once

#include "Base/IndexBox.h"

#include <numeric>

namespace vfm
{

/// Returns `count` sets of one item each.
inline std::vector<Index> MakeSets(std::size_t count)
{
  std::vector<Index> parent(count);
  std::iota(parent.begin(), parent.end(), 0);
  return parent;
}

/// Returns the lowest item of the set that contains an item, and shortens the path to it.
inline Index FindRoot(std::vector<Index>& parent, Index item)
{
  while (parent[item] != item)
  {
    parent[item] = parent[parent[item]];
    item = parent[item];
  }
  return item;
}

/// Joins the sets of two items. The lower root becomes the root, so a root is the lowest
/// item of its set.
inline void Join(std::vector<Index>& parent, Index a, Index b)
{
  a = FindRoot(parent, a);
  b = FindRoot(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
}

} // namespace vfm
