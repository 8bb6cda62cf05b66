/**
 * Number and quality of the elements of each material.
 */
#pragma once

#include "Elements/CellRuns.h"
#include "Elements/Mesh.h"
#include "Elements/MeshReport.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Sets Elements in report.Materials over all ranks, and the scaled Jacobians if
/// mesh.ScaledJacobian is computed.
/// @param mesh  mesh with owned elements only
/// @param[in,out] report  ReportVolumes must have made report.Materials
/// @param leftOut  hexes that the mesh leaves out; null: none
/// @pre Collective.
void MeasureMaterials(
  const Mesh& mesh, Ranks& ranks, MeshReport& report, const CellRuns* leftOut = nullptr);

} // namespace vfm
