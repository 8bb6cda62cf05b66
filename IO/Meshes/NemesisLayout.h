/**
 * NemesisLayout: what the file of one of several ranks says of the others: totals, and the nodes that ranks share.
 */
#pragma once

#include "Meshes/ExodusModel.h"
#include "Meshes/NetcdfLayout.h"

namespace vfm
{

/// Numbers of files and totals, which readers need first.
void AddNemesisHead(NetcdfLayout& layout, const ExodusModel& model, int ranks);

/// Nodes and elements inside and on the border, and one communication map per neighbour, whose id is the neighbour's
/// rank + 1.
void AddNemesis(NetcdfLayout& layout, const ExodusModel& model);

} // namespace vfm
