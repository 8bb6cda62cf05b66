/**
 * InputLabels: input given by one array of material labels, integers in any numeric type.
 */
#pragma once

#include "Input/InputFields.h"

namespace vfm
{

/// Opens the array of labels. Labels that occur on any rank and level get the material numbers 1..N
/// in increasing order.
/// @param levels blocks of each level; must outlive the result
/// @param name array of labels >= 0, in any numeric type with one component; 0 is void
/// @throws InputError if an array is missing or a value is not a label, on all ranks
/// @pre Collective
LevelCells OpenLabels(
  const std::vector<InputBlocks>& levels, const std::string& name, Ranks& ranks);

} // namespace vfm
