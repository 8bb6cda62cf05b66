/**
 * MissingLevels: levels of a refined grid (AMR) whose boxes are known, but whose data the reader has not loaded.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <string>

class vtkDataObject;

namespace vfm
{

/// Collective: empty, or which levels have boxes and on no rank data, and what to do. input: this rank's part, null for none.
std::string DescribeMissingLevels(vtkDataObject* input, Ranks& ranks);

} // namespace vfm
