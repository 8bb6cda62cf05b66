/**
 * GiveState: the phase that gives a mesh the state of its cells, and ends its copies across
 * periodic sides.
 */
#pragma once

#include "Base/Options.h"
#include "Phases/MesherResult.h"
#include "Phases/ReadCells.h"

namespace vfm
{

/// Fills MesherResult::State. A periodic mesh becomes a mesh of the domain.
/// @pre Collective.
void GiveState(
  const MesherJob& job, const MeshOptions& options, Cells& cells, MesherResult& result);

} // namespace vfm
