/**
 * The elements of each material of a mesh, and how good they are.
 */
#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Sets Elements, and MinimumScaledJacobian and MeanScaledJacobian where they are computed, of report.Materials, which ReportVolumes
/// makes: of the elements of all ranks, each of which is on one. Collective.
void MeasureMaterials(const Mesh& mesh, Ranks& ranks, MeshReport& report);

} // namespace vfm
