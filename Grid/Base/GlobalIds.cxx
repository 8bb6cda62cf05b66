#include "Base/GlobalIds.h"

#include "Base/Runtime.h"

#include <limits>

namespace vfm
{

void CheckIds(const CartesianGrid& grid, Index slots)
{
  double ids = static_cast<double>(slots);
  for (Index n : grid.Global().Upper)
  {
    ids *= static_cast<double>(n + 1);
  }
  if (ids >= static_cast<double>(std::numeric_limits<Index>::max()))
  {
    throw InputError("The grid has more nodes than 64-bit global ids can number.");
  }
}

} // namespace vfm
