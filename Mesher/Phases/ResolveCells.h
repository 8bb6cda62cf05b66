/**
 * ResolveCells: the label of each cell, such that a valid mesh can start.
 */
#pragma once

#include "Labels/Labels.h"
#include "Phases/MeshRun.h"

namespace vfm
{

/// Assigns labels to cells and changes them until a valid mesh can be made from them
/// (ResolveLabels.h).
/// @param keepsSeam  ResolveLabels
/// @pre Collective.
LabelArray ResolveCells(const MeshCells& cells, bool keepsSeam, MeshRun& run);

} // namespace vfm
