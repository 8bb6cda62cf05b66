/**
 * ViewMesh: a mesh and the state that its elements and points carry, in the form that reports and files are made from.
 */
#pragma once

#include "State/CarryState.h"
#include "Summary/MeshData.h"

namespace vfm
{

/// mesh, state: must outlive what is returned. fields: of the whole mesh; copied.
MeshData ViewMesh(
  const Mesh& mesh, const OutputState& state, const std::vector<FieldArray>& fields);

} // namespace vfm
