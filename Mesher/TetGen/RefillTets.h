/**
 * RefillTets: replaces the tets of a Cells mesh by tets of TetGen, fragment by fragment. Faces on
 * interfaces, on the domain boundary and between ranks are kept, so the mesh still conforms. The
 * surface of a local fragment consists of faces of Cells tets, so it never intersects itself.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Elements/MeshReport.h"
#include "Labels/Labels.h"
#include "TetGen/TetGenFill.h"

namespace vfm
{

/// Replaces the tets of each local fragment. A local fragment that TetGen rejects keeps its tets.
/// H. Si, TetGen, a Delaunay-based quality tetrahedral mesh generator, ACM Transactions on
/// Mathematical Software 41 (2015).
/// New points get ids after all ids of Cells, tets get ids from 1; both are numbered in the order
/// of ranks. The inner tets depend on the number of ranks.
/// @param mesh  smoothed Cells mesh with fragments and geometry, only the tets that this rank owns
/// @param labels  labels of the cells of grid.Local(), from which edge lengths are derived
/// @param progress  fraction done of this rank's fragments. If it throws Aborted, the
/// call ends and passes the exception on.
/// @param report  RefusedParts is set to the number of rejected local fragments of all ranks
/// @pre Collective.
void RefillTets(Mesh& mesh, const CartesianGrid& grid, const LabelArray& labels,
  const MeshOptions& options, const FillProgress& progress, Runtime& runtime, MeshReport& report);

} // namespace vfm
