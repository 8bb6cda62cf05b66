/**
 * ImageExtent: which values of an image an extent of VTK asks for.
 */
#pragma once

#include "Base/IndexBox.h"

#include <algorithm>

namespace vfm
{

inline bool IsEmptyExtent(const int extent[6])
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

/// Of an extent that is not empty, its points.
inline IndexBox FindPoints(const int extent[6])
{
  return { { { extent[0], extent[2], extent[4] } },
    { { Index(extent[1]) + 1, Index(extent[3]) + 1, Index(extent[5]) + 1 } } };
}

/// The cells of an extent of points; where it is flat, as VTK cuts pieces of less than a cell and slices, those beside it.
inline IndexBox FindCells(const int extent[6], const Index3& cells)
{
  IndexBox box;
  for (int a = 0; a < 3; ++a)
  {
    const bool isFlat = extent[2 * a] == extent[2 * a + 1];
    box.Lower[a] = std::min<Index>(extent[2 * a], isFlat ? cells[a] - 1 : cells[a]);
    box.Upper[a] = std::max(Index(extent[2 * a + 1]), box.Lower[a] + (isFlat ? 1 : 0));
  }
  return box;
}

} // namespace vfm
