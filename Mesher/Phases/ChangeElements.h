/**
 * ChangeElements: the phases that add elements, copies of points and mid nodes to a mesh.
 */
#pragma once

#include "Base/Options.h"
#include "Phases/MesherResult.h"
#include "Phases/ReadCells.h"

namespace vfm
{

/// Cuts layers and joins periodic sides, as the options request.
/// @pre Collective.
void AddLayersAndJoin(const MesherJob& job, const Cells& cells, MesherResult& result);

/// Splits interfaces and adds mid nodes, as the options request.
/// @param result  after ListResult; its fields change with the mesh
/// @pre Collective.
void SplitAndCurve(
  const MesherJob& job, const Cells& cells, const MeshOptions& options, MesherResult& result);

} // namespace vfm
