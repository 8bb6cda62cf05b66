/**
 * StateArrays: arrays of the input that are transferred to the mesh.
 */
#pragma once

#include "Input/InputLevels.h"

#include <string>
#include <vector>

namespace vfm
{

/// A state array; equal in all blocks and on all ranks.
struct StateArray
{
  std::string Name;
  int Type = 0; ///< one of ValueType
  int Components = 1;
  std::vector<std::string> ComponentNames; ///< empty, or one per component; "" if unnamed
  bool IsRotated = false; ///< true: copies are rotated from image axes to world coordinates
};

/// Finds the state arrays with given names.
/// @param names distinct names of arrays of any numeric type and number of components
/// @return arrays in the order of names; component names are from the first block of the coarsest
/// level on the lowest rank that has blocks
/// @throws InputError if an array is missing in a block, or if types or components differ; on
/// all ranks
/// @pre Collective
std::vector<StateArray> FindStateArrays(
  const InputLevels& input, const std::vector<std::string>& names, Ranks& ranks);

/// Throws InputError if a name is reserved for arrays of the mesh.
void CheckNameOfState(const std::string& name);

/// Returns the type of values in messages and on the mesh: UnsignedChar for Bit, else the
/// same type.
int CarrierType(int type);
/// Returns the size of a tuple of this type, in bytes.
std::size_t TupleSize(const StateArray& array);

} // namespace vfm
