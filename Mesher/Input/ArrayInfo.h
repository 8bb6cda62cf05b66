/**
 * ArrayInfo: type, components and range of the arrays of one name, over the blocks or data sets of
 * all ranks.
 */
#pragma once

#include "Input/InputBlocks.h"
#include "Ranks/Ranks.h"

#include <string>
#include <vector>

namespace vfm
{

/// Largest distance of a real number from the integer that it is read as.
constexpr double LabelTolerance = 1e-3;

struct ArrayInfo
{
  std::string Name;
  int Type = 0; ///< ValueType of the first array
  int Components = 0;
  double Least = 0.0, Most = 0.0; ///< range of the first component, without NaN
  Index Count = 0;                ///< number of arrays
  bool HasOneType = true;
  bool HoldsIds = false; ///< true if any array is a global or pedigree id
  bool AreWhole = false; ///< all values are integers within LabelTolerance
  double NotWhole = 0.0; ///< the first value that is not; 0: there is none
};

/// Adds an array to a list, or merges it with the entry of the same name.
void AddArray(std::vector<ArrayInfo>& list, const ArrayInfo& info);

/// Merges the lists of all ranks.
/// @param mine arrays of this rank
/// @return arrays of all ranks, ordered by rank and place in its list
/// @pre Collective
std::vector<ArrayInfo> UnionOfArrays(const std::vector<ArrayInfo>& mine, Ranks& ranks);

/// The arrays of all blocks or data sets of a rank.
using ArrayLists = std::vector<std::shared_ptr<const BlockArrays>>;

/// Returns the arrays of each block.
ArrayLists ListsOf(const std::vector<InputBlock>& blocks);

/// Returns the arrays of this rank that have values.
std::vector<ArrayInfo> ListArrays(const ArrayLists& lists);

} // namespace vfm
