/**
 * From volume fractions to the hexahedral mesh: all stages in order.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshReport.h"

namespace vfm
{

/// Meshes the owned cells of a grid with the ghost layers that LayersFor(options.Levels) tells. Throws InputError (options out of range, ids over 63 bits) and Aborted.
/// The mesh is valid for any labels: every corner of every hex has a positive Jacobian.
Mesh MakeHexMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report);

} // namespace vfm
