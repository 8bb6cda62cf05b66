/**
 * Counts the connected parts of sets of cells, cell by cell.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <functional>

namespace vfm
{
namespace testing
{

/// Which cells are joined.
enum class Joins
{
  Faces,
  FacesEdgesCorners
};

/// Returns the number of connected parts of the cells of the domain for which isIn(linear index)
/// holds.
int CountCellParts(const CartesianGrid& grid, Joins joins, const std::function<bool(Index)>& isIn);

} // namespace testing
} // namespace vfm
