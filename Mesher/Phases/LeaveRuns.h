/**
 * LeaveRuns: whether the mesh of a run may leave out hexes of unchanged cells.
 */
#pragma once

#include "Elements/CellRuns.h"
#include "Phases/ReadCells.h"

namespace vfm
{

/// Returns whether no later phase of the run reads or changes hexes far from interfaces: linear
/// hexahedra of the cells as read, without state, layers, split interfaces or particles, in the
/// axes of the grid. Meshes on several ranks have all hexes.
bool CanLeaveRuns(const MesherJob& job, const Cells& cells);

/// Replaces material numbers by the ids of the user.
void UseLabels(const Materials& table, CellRuns& runs);

} // namespace vfm
