/**
 * CellCount: number of cells or values of a box of any size, without overflow.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Ranks/Errors.h"

#include <string>

namespace vfm
{

/// Returns the number of cells of a box. A size below 0 counts as 0. The result times 64 bytes is
/// an Index.
/// @throws InputError  if there are more than 2^56 cells
inline Index CountCells(const Index3& size)
{
  constexpr Index most = Index(1) << 56;
  Index count = 1;
  for (const Index n : size)
  {
    if (n <= 0)
    {
      return 0;
    }
    count = count > most / n ? most + 1 : count * n;
  }
  if (count > most)
  {
    throw InputError("its size of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " x " + std::to_string(size[2]) + " is too large; at most 2^56 values are supported.");
  }
  return count;
}

} // namespace vfm
