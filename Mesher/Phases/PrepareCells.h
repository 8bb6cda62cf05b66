/**
 * PrepareCells: the phase that changes the fractions before elements are made: copies across
 * periodic sides, small regions, smooth labels, divided and refined cells.
 */
#pragma once

#include "Base/Options.h"
#include "Labels/SmallRegions.h"
#include "Phases/ReadCells.h"

namespace vfm
{

struct PreparedCells
{
  MeshOptions Options; ///< of the elements
  RemovedRegions Removed;
};

/// Changes Cells::Fields as the options request.
/// @pre Collective.
PreparedCells PrepareCells(const MesherJob& job, Cells& cells);

} // namespace vfm
