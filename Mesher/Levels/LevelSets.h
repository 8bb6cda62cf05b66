/**
 * LevelSets: volume fractions from arrays that are level sets, the option LevelSets.
 *
 * A value belongs to the centre of its cell. The fractions of a cell depend on the values within
 * two cells of it (LevelSetCell.h), of the same level, whatever block and rank holds them. Values
 * across the sides of the domain and of a level are extrapolated.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/LevelSetRule.h"
#include "Input/InputBlocks.h"

namespace vfm
{

/// Arrays that are level sets, and how they are read.
struct LevelSetSource
{
  std::vector<std::string> Arrays;            ///< one per material, in order of priority
  LevelSetRule Rule = LevelSetRule::Priority; ///< not Off
  bool IsPositiveInside = false;
};

/// Returns the blocks with volume fractions in place of level sets. Blanked cells are void, and a
/// cell whose value is NaN has NaN in all arrays, which the checks of fractions report.
/// @param levels  blocks of each level
/// @return the same boxes, with the arrays of the source only, of type double
/// @throws InputError if an array is missing, or if no value of any array is inside; on all ranks
/// @pre Collective
std::vector<InputBlocks> FractionsOfLevelSets(
  const std::vector<InputBlocks>& levels, const LevelSetSource& source, Runtime& runtime);

} // namespace vfm
