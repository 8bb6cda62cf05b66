/**
 * Random fields of fractions: smooth shapes, noise, and what is hard to mesh.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "RandomDraw.h"

namespace vfm
{
namespace testing
{

/// A field in the cells of a whole grid, of one kind drawn. words: gets the name of the kind.
FractionField DrawField(
  const CartesianGrid& grid, int materials, RandomDraw& draw, std::string& words);

} // namespace testing
} // namespace vfm
