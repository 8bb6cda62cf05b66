/**
 * TetPipeline: makes a tetrahedral mesh from volume fractions.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Elements/MeshReport.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Makes the tetrahedral mesh of the owned cells. The mesh is valid for any labels: every tet
/// has a positive volume.
/// @param grid  grid with GhostLayers ghost layers
/// @param fractions  fractions of the local cells
/// @param options  options; FineInterfaces is always on for tets
/// @param[out] report  measurements over all ranks
/// @return elements of the owned cells; each element is on one rank
/// @throws InputError  if an option is out of range, ids exceed 63 bits, or the build has no TetGen
/// @throws Aborted  if the user stops the run
/// @pre Collective over runtime.Group().
Mesh MakeTetMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report);

/// Returns whether this build includes TetGen.
bool HasTetGen();

} // namespace vfm
