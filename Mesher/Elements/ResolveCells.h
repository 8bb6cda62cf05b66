/**
 * ResolveCells: the label of each cell, such that a valid mesh can start.
 */
#pragma once

#include "Elements/MeshRun.h"
#include "Labels/ResolveLabels.h"

namespace vfm
{

/// Copies the counts of flipped cells into the report of a mesh.
void ReportFlips(const ResolveReport& resolved, MeshReport& report);

/// Assigns labels to cells and changes them until a valid mesh can be made from them
/// (ResolveLabels.h).
/// @param keepsSeam  ResolveLabels
/// @pre Collective.
LabelArray ResolveCells(const MeshCells& cells, bool keepsSeam, MeshRun& run);

} // namespace vfm
