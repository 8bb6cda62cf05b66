/**
 * Input given by one volume fraction array a material.
 */
#pragma once

#include "Input/InputFields.h"

namespace vfm
{

/// Collective. Fractions of material m are in the array names[m - 1]: of any type with one component, unsigned
/// char counting 0..255. tolerance: how far outside [0, 1] values may lie, >= FractionTolerance. levels must outlive the result. Throws
/// InputError, on all ranks alike, on missing arrays.
LevelCells OpenFractions(const std::vector<InputBlocks>& levels,
  const std::vector<std::string>& names, double tolerance, Ranks& ranks);

} // namespace vfm
