/**
 * FindArrays: what is known of the arrays of data sets.
 */
#pragma once

#include "Input/ArrayInfo.h"

class vtkDataSetAttributes;

namespace vfm
{

/// Collective: the numeric arrays that have values, in the order in which data sets list them. attributes: of this rank's data sets.
std::vector<ArrayInfo> FindArrays(
  const std::vector<vtkDataSetAttributes*>& attributes, Ranks& ranks);

} // namespace vfm
