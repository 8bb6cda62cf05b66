/**
 * ChooseMaterials: selects the arrays of materials if the user does not, for all front ends.
 */
#pragma once

#include "Materials/ArrayContent.h"

#include <string>
#include <vector>

namespace vfm
{

/// What a front end knows about the arrays.
struct ChoiceRules : ContentRules
{
  std::vector<std::string> Others; ///< arrays with another purpose, such as state
  bool HasThreshold = false;       ///< materials are ranges of the values of one array
  bool ArePoints = false;          ///< the arrays belong to points; for messages
};

struct MaterialChoice
{
  std::vector<std::string> Fractions;   ///< arrays of material 1, 2, ...
  std::string Labels;                   ///< array of labels; empty: fractions, or nothing
  std::string How;                      ///< reason of the choice
  std::string Problem;                  ///< reason if nothing is chosen; otherwise empty
  bool AreNamed = false;                ///< Fractions were found by their names
  bool IsClear = false;                 ///< no other array or role is possible
  std::vector<ContentOfArray> Contents; ///< of each array of the list
};

/// Selects the arrays of materials:
/// 1. arrays with names as in SpyPlot files, ordered by their numbers
/// 2. reals with names that say volume fraction, if any of them is in [0, 1]
/// 3. all other fractions, and masks of integers; not next to labels with a usual name except
///    MaterialId, not next to masks named as state, and not if all are masks next to labels
/// 4. the array of integers with the most usual name of labels
/// 5. the only array of integers; or several masks, as one material each
/// 6. the same for real numbers that are integers
/// Nothing from 3 on if the content of an array is unclear.
MaterialChoice ChooseMaterials(const std::vector<ArrayInfo>& arrays, const ChoiceRules& rules);

} // namespace vfm
