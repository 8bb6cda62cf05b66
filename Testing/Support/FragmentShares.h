/**
 * Shares of fragments for tests.
 */
#pragma once

#include "Labels/FragmentShare.h"

namespace vfm
{
namespace testing
{

/// Returns a share in which every rank touches all fragments, so both numbers are equal.
/// @pre Collective.
inline FragmentShare ShareOfAll(Index count, Ranks& ranks)
{
  FragmentShare share;
  std::vector<Index> keys;
  for (Index f = 1; f <= count; ++f)
  {
    share.Ids.push_back(static_cast<int>(f));
    share.Shared.push_back(static_cast<int>(f));
    keys.push_back(f);
  }
  share.Materials.assign(share.Size(), 0);
  share.IsMine.assign(share.Size(), ranks.Rank() == 0);
  share.IsShared.assign(share.Size(), 1);
  share.Ways = KeyMerge<Index>(std::move(keys), ranks);
  share.Total = count;
  share.Group = &ranks;
  return share;
}

} // namespace testing
} // namespace vfm
