/**
 * Periodic axes of a random case.
 */
#pragma once

#include "FuzzCase.h"
#include "RandomDraw.h"

namespace vfm
{
namespace testing
{

/// Returns a number of cells that is near and can be periodic along each axis: 3 to 8, and even if
/// refined.
Index3 FitPeriods(const Index3& cells, bool isRefined);

/// Makes a case periodic: adds copies of the cells to its grid.
void DrawPeriods(RandomDraw& draw, FuzzCase& c);

} // namespace testing
} // namespace vfm
