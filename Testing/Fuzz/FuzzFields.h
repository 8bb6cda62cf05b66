/**
 * Random fields of fractions: smooth shapes, noise, and fields that are difficult to mesh.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "RandomDraw.h"

namespace vfm
{
namespace testing
{

/// Returns a field of one random kind in the cells of a whole grid. words:
/// receives the name of the kind.
FractionField DrawField(
  const CartesianGrid& grid, int materials, RandomDraw& draw, std::string& words);

} // namespace testing
} // namespace vfm
