/**
 * InputFractions: input given by one volume fraction array per material.
 */
#pragma once

#include "Input/InputFields.h"

namespace vfm
{

/// Opens the arrays of volume fractions.
/// @param levels blocks of each level; must outlive the result
/// @param names array of each material, of any numeric type with one component; values of type
/// unsigned char are divided by 255, unless they are masks (AreMasks)
/// @param tolerance maximum distance of values from [0, 1], at least FractionTolerance
/// @param labelsOption as in AreMasks
/// @throws InputError if an array is missing, or if AreMasks or CheckSums do; on all ranks
/// @pre Collective
LevelCells OpenFractions(const std::vector<InputBlocks>& levels,
  const std::vector<std::string>& names, double tolerance, const std::string& labelsOption,
  Ranks& ranks);

} // namespace vfm
