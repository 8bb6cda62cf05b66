/**
 * LevelSetRule: the materials that level sets stand for, the option LevelSets.
 */
#pragma once

namespace vfm
{

/// Which material a point has, of functions that are negative inside their materials.
enum class LevelSetRule
{
  Off,      ///< the arrays of the materials are volume fractions
  Priority, ///< the first function that is negative
  Lowest,   ///< the function of the lowest value, if it is negative
  Fill      ///< the function of the lowest value; there is no void
};

} // namespace vfm
