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

/// The array of the materials.
struct ArrayChoice
{
  const std::string& Name;
  const std::string& LabelsOption; ///< words in front of the array of labels, in messages
  bool IsGuessed;                  ///< the user did not select it
};

/// Checks whether labels look like grey values. The result does not depend on the number of ranks.
/// @param fields  materials of labels, before copies of cells are added
/// @return a warning, or ""
/// @throws InputError  in place of a warning, if the user did not select the array; on all ranks
/// @pre Collective
std::string CheckGreyLabels(const LevelFields& fields, const ArrayChoice& choice, Ranks& ranks);

/// Checks in the same way whether one material of bytes, whose name does not say volume fraction,
/// looks like grey values or labels: it has several values, and most cells are neither empty nor
/// full.
std::string CheckGreyFractions(
  const LevelFields& fields, const ArrayChoice& choice, const InputLevels& input, Ranks& ranks);

} // namespace vfm
