/**
 * The elements of each material of a mesh, and how good they are.
 */
#pragma once

#include "Base/Ranks.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"

namespace vfm
{

/// Fills Elements, and MinimumScaledJacobian and MeanScaledJacobian where the mesh has them, of report.Materials: of the elements of all
/// ranks, which each are on one. Takes 32 bytes a material. Collective.
void MeasureMaterials(const Mesh& mesh, Ranks& ranks, MeshReport& report);

} // namespace vfm
