/**
 * MissingLevels: finds levels of a refined grid (AMR) whose data the reader has not loaded.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <string>

class vtkDataObject;

namespace vfm
{

/// Returns a warning with the levels that have boxes, but no data on any rank; empty if there
/// are none.
/// @param input part of this rank; null: none
/// @pre Collective
std::string DescribeMissingLevels(vtkDataObject* input, Ranks& ranks);

} // namespace vfm
