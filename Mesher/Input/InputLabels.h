/**
 * Input given by one array of material labels, whole numbers of any type.
 */
#pragma once

#include "Input/InputFields.h"

namespace vfm
{

/// Collective. Labels >= 0 are in an array of whole numbers of any type, 0 void. The labels that occur on any rank and level are numbered
/// 1..N in increasing order. levels must outlive the result. Throws InputError, on all ranks alike, on missing arrays, values that are
/// no labels.
LevelCells OpenLabels(
  const std::vector<InputBlocks>& levels, const std::string& name, Ranks& ranks);

} // namespace vfm
