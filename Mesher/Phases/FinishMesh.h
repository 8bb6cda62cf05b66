/**
 * FinishMesh: the phase that turns a draft into the mesh of the owned cells.
 */
#pragma once

#include "Phases/ElementMethod.h"

namespace vfm
{

/// Finds the geometry, keeps the elements of the owned cells, and fills the report.
/// @pre Collective.
Mesh FinishMesh(const MeshCells& cells, ElementMethod& method, MeshRun& run, Draft draft);

} // namespace vfm
