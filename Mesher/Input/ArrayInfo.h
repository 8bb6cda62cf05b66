/**
 * ArrayInfo: what the arrays of a name hold, in the blocks or data sets of all ranks together.
 */
#pragma once

#include "Input/InputBlocks.h"
#include "Ranks/Ranks.h"

#include <string>
#include <vector>

namespace vfm
{

struct ArrayInfo
{
  std::string Name;
  int Type = 0; ///< of ValueType, of the first
  int Components = 0;
  double Least = 0.0, Most = 0.0; ///< of the first component, NaN left out
  Index Count = 0;                ///< of the arrays
  bool HasOneType = true;
  bool HoldsIds = false; ///< some are global or pedigree ids
};

/// Adds an array to a list, or to the one of its name there.
void AddArray(std::vector<ArrayInfo>& list, const ArrayInfo& info);

/// Collective. mine: arrays of this rank. Returns those of all ranks, in the order in which ranks list them.
std::vector<ArrayInfo> UnionOfArrays(const std::vector<ArrayInfo>& mine, Ranks& ranks);

/// The arrays of the blocks or data sets of a rank.
using ArrayLists = std::vector<std::shared_ptr<const BlockArrays>>;

ArrayLists ListsOf(const std::vector<InputBlock>& blocks);

/// Returns the arrays of this rank that have values.
std::vector<ArrayInfo> ListArrays(const ArrayLists& lists);

} // namespace vfm
