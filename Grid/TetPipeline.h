/**
 * From volume fractions to the tetrahedral mesh: all stages in order.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"

namespace vfm
{

/// Meshes the owned cells of the grid. Throws InputError (options out of range, ids over 63 bits) and Aborted.
/// The mesh is valid for any labels: every tet has a positive volume. Collective.
Mesh MakeTetMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report);

/// Whether TetMethod::TetGen was built in.
bool HasTetGen();

} // namespace vfm
