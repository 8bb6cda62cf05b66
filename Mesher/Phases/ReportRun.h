/**
 * ReportRun: the phase that puts a mesh into world coordinates and lists its fields, and the
 * warnings of a run.
 */
#pragma once

#include "Base/Options.h"
#include "Phases/MesherResult.h"
#include "Phases/ReadCells.h"

namespace vfm
{

/// Gives every rank the tables of all surfaces and curves of the mesh if option WholeTables says
/// so. Otherwise ranks keep the rows of what they touch, with EdgeFacets of all facets of their
/// elements; warns if files lose the names of surfaces.
/// @pre Collective.
void GatherTables(const MesherJob& job, MesherResult& result);

/// Transforms the mesh to world coordinates, gives its materials the ids of the user, and lists its
/// fields.
/// @pre Collective.
void ListResult(
  const MesherJob& job, const Cells& cells, const MeshOptions& options, MesherResult& result);

/// Warns of corrected input, an empty mesh, and materials without elements, with wrong volumes or
/// with contents that no element has.
void WarnOfResult(const MesherJob& job, const Cells& cells, const MesherResult& result);

} // namespace vfm
