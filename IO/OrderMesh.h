/**
 * OrderMesh: a mesh made ready to be written, wherever it comes from.
 */
#pragma once

#include "Ranks/Ranks.h"

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace vfm
{

/// Collective: this rank's part with points and cells in the order of their global ids, each once; GlobalPointIds and
/// GlobalCellIds are its global ids; DATA_TIME_STEP is set, to 0 when no rank has a time; ranks without elements have the head
/// (ShareHead). The mesh itself does not change. Throws InputError, on all ranks alike, when the mesh is empty, has no such ids from 1, or
/// is neither all hexahedra nor all tetrahedra.
vtkSmartPointer<vtkUnstructuredGrid> OrderMesh(vtkUnstructuredGrid* mesh, Ranks& ranks);

/// Collective: the same of the whole mesh on rank 0, null on the others (GatherMesh).
vtkSmartPointer<vtkUnstructuredGrid> OrderWholeMesh(vtkUnstructuredGrid* mesh, Ranks& ranks);

} // namespace vfm
