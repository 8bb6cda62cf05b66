/**
 * From volume fractions to the hexahedral mesh: all stages in order.
 */
#pragma once

#include "FractionField.h"
#include "HexMesh.h"
#include "Runtime.h"

namespace vfm
{

/// Meshes the owned cells of the grid. Throws InputError (options out of range, ids over 63 bits) and Aborted.
/// The mesh is valid for any labels: every corner of every hex has a positive Jacobian.
HexMesh MakeHexMesh(const CartesianGrid& grid, const FractionField& fractions,
  const HexMeshOptions& options, Runtime& runtime, HexMeshReport& report);

} // namespace vfm
