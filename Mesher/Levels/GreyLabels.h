/**
 * GreyLabels: recognises grey values that are used as labels, or as fractions of 255.
 *
 * Labels have regions; grey values change from cell to cell. A cell is busy if the next cell along
 * an axis has another label above 0. A label is thin if most of its cells are busy.
 */
#pragma once

#include "Levels/LevelFields.h"

#include <string>

namespace vfm
{

/// Returns a description of labels that look like grey values, otherwise "". The result does not
/// depend on the number of ranks.
/// @param field materials of labels, before copies of cells are added
/// @pre Collective
std::string DescribeGreyLabels(const LevelFields& fields, Ranks& ranks);

/// Returns a description of one material of bytes that looks like grey values or labels, because it
/// has several values and most cells are neither empty nor full, otherwise "". The result does not
/// depend on the number of ranks.
/// @pre Collective
std::string DescribeGreyFractions(const LevelFields& fields, Ranks& ranks);

} // namespace vfm
