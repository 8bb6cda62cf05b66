/**
 * StateArray: an array of the input whose values the elements of the mesh carry, the same in all blocks of all ranks.
 */
#pragma once

#include "Input/InputLevels.h"

#include <string>
#include <vector>

namespace vfm
{

/// The same on all ranks.
struct StateArray
{
  std::string Name;
  int Type = 0; ///< of ValueType
  int Components = 1;
  std::vector<std::string> ComponentNames; ///< empty, or one a component, "" where it has none
};

/// Collective. names: distinct arrays of any numeric type and number of components. Throws InputError, on all ranks alike, when a block has
/// none, or blocks disagree on type or components. Component names: those of the lowest rank's first block of the coarsest level.
std::vector<StateArray> FindStateArrays(
  const InputLevels& input, const std::vector<std::string>& names, Ranks& ranks);

/// Throws InputError when the mesh itself may have an array of that name.
void CheckNameOfState(const std::string& name);

/// The type in which values travel: bits do so as bytes.
int CarrierType(int type);
/// In that type, in bytes.
std::size_t TupleSize(const StateArray& array);

} // namespace vfm
