/**
 * NemesisLayout: adds to the Exodus file of one of several ranks the totals over all ranks and the
 * nodes that ranks share.
 */
#pragma once

#include "Meshes/Exodus/ExodusModel.h"
#include "Meshes/Exodus/NetcdfLayout.h"

namespace vfm
{

/// Adds the number of files and the totals, which must come first in a file.
void AddNemesisHead(NetcdfLayout& layout, const ExodusModel& model, int ranks);

/// Adds the internal and border nodes and elements, and one communication map per neighbour rank.
/// The id of a map is the neighbour rank + 1.
void AddNemesis(NetcdfLayout& layout, const ExodusModel& model);

} // namespace vfm
