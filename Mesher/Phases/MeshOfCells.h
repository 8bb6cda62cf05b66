/**
 * MeshOfCells: makes a mesh of hexahedra or tetrahedra from the volume fractions of a grid.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Elements/MeshReport.h"
#include "Fractions/FractionField.h"
#include "Options/MesherOptions.h"

namespace vfm
{

struct MeshCells;

/// Makes the mesh of cells as MakeHexMesh or MakeTetMesh does, also with surfaces of bodies.
Mesh MakeMeshOfCells(
  ElementKind elements, const MeshCells& cells, Runtime& runtime, MeshReport& report);

/// Makes the hexahedral mesh of the owned cells. The mesh is valid for any labels: every corner of
/// every hex has a positive Jacobian.
/// @param grid  grid with the ghost layers that LayersFor(options.Levels) returns
/// @param fractions  fractions of the local cells
/// @param[out] report  measurements over all ranks
/// @return elements of the owned cells; each element is on one rank
/// @throws InputError  if an option is out of range or ids exceed 63 bits
/// @throws std::logic_error  if the grid has too few ghost layers
/// @throws Aborted  if the user stops the run
/// @pre Collective over runtime.Group().
Mesh MakeHexMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report);

/// Makes the tetrahedral mesh of the owned cells. The mesh is valid for any labels: every tet
/// has a positive volume. Arguments and results are those of MakeHexMesh.
/// @param grid  grid with GhostLayers ghost layers
/// @param options  options; FineInterfaces is always on for tets
/// @throws InputError  if the build has no TetGen, too
/// @pre Collective over runtime.Group().
Mesh MakeTetMesh(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report);

/// Returns whether this build includes TetGen.
bool HasTetGen();

} // namespace vfm
