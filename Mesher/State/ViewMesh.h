/**
 * ViewMesh: views a mesh and its state as MeshData, for reports and file writers.
 */
#pragma once

#include "Report/MeshData.h"
#include "State/OutputState.h"

namespace vfm
{

/// Returns a view of a mesh.
/// @param mesh,state must outlive the result
/// @param fields arrays of the whole mesh; copied
MeshData ViewMesh(
  const Mesh& mesh, const OutputState& state, const std::vector<FieldArray>& fields);

} // namespace vfm
