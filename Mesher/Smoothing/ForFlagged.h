/**
 * ForFlagged: passes over flags of which few are set.
 */
#pragma once

#include "Base/Runtime.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace vfm
{

/// Calls visit(i) for the flags from first to before last that are set, ascending. Looks at eight
/// flags at once where none is set.
template <class Visitor>
void ForFlagged(
  const std::vector<unsigned char>& flags, Index first, Index last, const Visitor& visit)
{
  const unsigned char* const data = flags.data();
  for (Index i = first; i < last;)
  {
    std::uint64_t eight = 1;
    if (i + 8 <= last)
    {
      std::memcpy(&eight, data + i, 8);
    }
    const Index end = std::min(i + 8, last);
    for (; eight != 0 && i < end; ++i)
    {
      if (data[i])
      {
        visit(i);
      }
    }
    i = end;
  }
}

/// Does the same for all flags, with several threads.
template <class Visitor>
void ForFlagged(Runtime& runtime, const std::vector<unsigned char>& flags, const Visitor& visit)
{
  runtime.For(0, static_cast<Index>(flags.size()),
    [&](Index first, Index last) { ForFlagged(flags, first, last, visit); });
}

} // namespace vfm
