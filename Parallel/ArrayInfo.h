/**
 * ArrayInfo: what the arrays of a name hold, in the data sets of all ranks together.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Ranks/Ranks.h"

#include <string>
#include <vector>

class vtkDataSetAttributes;

namespace vfm
{

struct ArrayInfo
{
  std::string Name;
  int Type = 0; ///< VTK_FLOAT, ..., of the first
  int Components = 0;
  double Least = 0.0, Most = 0.0; ///< of the first component, NaN left out
  Index Count = 0;                ///< of the arrays
  bool HasOneType = true;
  bool HoldsIds = false; ///< some are global or pedigree ids
};

/// Collective: the numeric arrays that have values, in the order in which data sets list them. attributes: of this rank's data sets.
std::vector<ArrayInfo> FindArrays(
  const std::vector<vtkDataSetAttributes*>& attributes, Ranks& ranks);

} // namespace vfm
