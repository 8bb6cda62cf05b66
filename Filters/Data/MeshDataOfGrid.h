/**
 * MeshDataOfGrid: a mesh of VTK, also one read from a file, as MeshData.
 */
#pragma once

#include "Summary/MeshData.h"

class vtkUnstructuredGrid;

namespace vfm
{

/// Views the memory of the mesh, which it keeps, and owns copies where types or layouts are others. Arrays without a name or without numbers
/// are left out; so is the kind of an empty mesh (Corners are 8). Throws InputError when cells are not all hexahedra or
/// all tetrahedra.
StoredMesh MeshDataOf(vtkUnstructuredGrid* mesh);

} // namespace vfm
