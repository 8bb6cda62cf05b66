/**
 * InputLabels: input given by one array of material labels, integers in any numeric type.
 */
#pragma once

#include "Input/InputFields.h"
#include "Options/ValueRanges.h"

namespace vfm
{

/// An array of labels, and how it is read.
struct LabelSource
{
  std::string Array; ///< labels >= 0, in any numeric type with one component; or any values
  std::vector<ValueRange> Ranges{}; ///< if not empty, the label is the number of the range, from 1
  bool IsZeroMaterial = false;      ///< false: label 0 is void
};

/// Opens the array of labels. Labels that occur on any rank and level get the material numbers 1..N
/// in increasing order; label 0, if it is a material, the number N + 1 and the largest id + 1.
/// Reals within LabelTolerance of an integer are that integer.
/// @param levels blocks of each level; must outlive the result
/// @throws InputError if an array is missing or a value is not a label, on all ranks
/// @pre Collective
LevelCells OpenLabels(
  const std::vector<InputBlocks>& levels, const LabelSource& source, Ranks& ranks);

} // namespace vfm
