/**
 * Random grids: cubes, stretched, graded and uneven cells; far from the origin; of any scale.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "RandomDraw.h"

#include <string>

namespace vfm
{
namespace testing
{

struct FuzzGrid
{
  CartesianGrid Grid;
  bool HasCubes;
  std::string Words;
};

/// Returns a random grid. cells: along each axis.
FuzzGrid DrawGrid(const Index3& cells, RandomDraw& draw);

} // namespace testing
} // namespace vfm
