/**
 * GatherTables: the tables of the geometry of the whole mesh on every rank.
 */
#pragma once

#include "Elements/GeometryTables.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Gives every rank the rows of all surfaces: SurfaceVolumes to SurfaceNormals, PatchNames,
/// VolumeSurfaces and EdgeFacets.
/// @param[in,out] tables  with the rows of this rank
/// @pre Collective.
void GatherSurfaceTables(Ranks& ranks, GeometryTables& tables);

/// Gives every rank the rows of all curves: CurveEnds, SurfaceCurves and CurveVertices.
/// @param[in,out] tables  with the rows of this rank
/// @pre Collective.
void GatherCurveTables(Ranks& ranks, GeometryTables& tables);

} // namespace vfm
