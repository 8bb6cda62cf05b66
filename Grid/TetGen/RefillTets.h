/**
 * The tets of Cells replaced by those of TetGen, fragment by fragment. The faces on interfaces, on sides of the
 * domain and between ranks stay as they are, so everything still matches. A rank's part of a fragment is bounded by
 * faces of tets of Cells, so its surface never cuts itself.
 */
#pragma once

#include "Base/Options.h"
#include "Labels/Labels.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"
#include "Ranks/Ranks.h"
#include "TetGen/TetGenFill.h"

namespace vfm
{

/// mesh: of Cells, smoothed, the tets of this rank only. What TetGen refuses stays as it is and is counted in
/// report.RefusedParts. New points get ids after those of Cells, all tets ids from 1, both by rank. progress: of all parts of this
/// rank; Aborted that it throws ends the work. Collective.
void RefillTets(Mesh& mesh, const CartesianGrid& grid, const LabelArray& labels,
  const MeshOptions& options, const FillProgress& progress, Ranks& ranks, MeshReport& report);

} // namespace vfm
